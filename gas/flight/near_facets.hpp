// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "solver/base/simd.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// By bits: which of eight lanes are set, one after another.
inline constexpr auto LANES_SET = [] {
    std::array<std::array<std::int32_t, EIGHT>, 256> out{};
    for (unsigned bits = 0; bits < out.size(); ++bits)
        for (int l = 0, n = 0; l < EIGHT; ++l)
            if ((bits >> l & 1U) != 0) out[bits][n++] = l;
    return out;
}();

/// Writes the lanes whose bits are set, one after another, without branches that nobody could
/// foretell; room for eight is needed.
template <class T>
void write_lanes(unsigned bits, const T* from, T* to) {
    static_assert(sizeof(T) == sizeof(EightBits) / EIGHT);
    EightBits lanes, numbers;
    std::memcpy(&lanes, &LANES_SET[bits], sizeof(lanes));
    std::memcpy(&numbers, from, sizeof(numbers));
    numbers = shuffled(numbers, lanes);
    std::memcpy(to, &numbers, sizeof(numbers));
}

/// Facets that a path may meet, and the share of it before which it does not.
class NearFacets {
public:
    static constexpr int EIGHTS_AT_ONCE = 64;

    [[nodiscard]] bool is_empty() const { return count_ == 0; }
    void clear() { count_ = 0; }
    /// Those of an eight that are met within the path.
    void add(const std::array<Index, EIGHT>& facets, const Eight& share) {
        add(facets, bits_of(share <= all_eight(1.0F)), share);
    }
    void add(const std::array<Index, EIGHT>& facets, unsigned bits, const Eight& share) {
        write_lanes(bits, facets.data(), facet_.data() + count_);
        write_lanes(bits, reinterpret_cast<const float*>(&share), share_.data() + count_);
        count_ += std::popcount(bits);
    }
    struct One {
        Index facet;
        float share;
    };
    One take_nearest() {
        int least = 0;
        for (int i = 1; i < count_; ++i) least = share_[i] < share_[least] ? i : least;
        const One out{facet_[least], share_[least]};
        --count_;
        facet_[least] = facet_[count_];
        share_[least] = share_[count_];
        return out;
    }

private:
    static constexpr std::size_t ROOM = (EIGHTS_AT_ONCE + 1) * EIGHT;
    int count_ = 0;
    std::array<Index, ROOM> facet_;
    std::array<float, ROOM> share_;
};

/// A bit for each of up to eight numbers that is there.
inline unsigned those(const std::array<Index, EIGHT>& numbers) {
    unsigned bits = 0;
    for (int l = 0; l < EIGHT; ++l) bits |= static_cast<unsigned>(numbers[l] >= 0) << l;
    return bits;
}

}  // namespace corpuscle::gas
