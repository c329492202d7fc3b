// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace corpuscle::io {

/// A file of a d3plot database in the making: words of 4 bytes, padded to blocks of 512.
class D3plotWords {
public:
    void integer(std::int64_t value) {
        put(std::bit_cast<std::uint32_t>(static_cast<std::int32_t>(value)));
    }
    void real(double value) { put(std::bit_cast<std::uint32_t>(static_cast<float>(value))); }
    void reals(const std::vector<double>& values) {
        for (const double value : values) real(value);
    }
    /// Cut or filled with blanks to so many words.
    void text(std::string value, std::size_t words) {
        value.resize(4 * words, ' ');
        bytes_ += value;
    }
    [[nodiscard]] std::string padded() && {
        constexpr std::size_t BLOCK = 4 * 512;
        bytes_.resize((bytes_.size() + BLOCK - 1) / BLOCK * BLOCK, '\0');
        return std::move(bytes_);
    }

private:
    void put(std::uint32_t word) {
        std::array<char, 4> four{};
        std::memcpy(four.data(), &word, 4);
        bytes_.append(four.data(), 4);
    }
    std::string bytes_;
};

}  // namespace corpuscle::io
