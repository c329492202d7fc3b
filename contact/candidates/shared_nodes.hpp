// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/candidates/blocks.hpp"

namespace corpuscle::contact {

/// Which lanes of two blocks have a node in common: neighbours on the cloth, which are always near
/// and never a pair. They never change, so the search passes them over eight at a time.
class SharedNodes {
public:
    template <int A, int B>
    SharedNodes(const Blocks<A>& mine, const Blocks<B>& others);

    /// Bit 8 l + m: lane l of one of my blocks has a node of lane m of another block.
    [[nodiscard]] std::uint64_t lanes(Index mine, Index other) const {
        for (Index i = start_[mine]; i < start_[mine + 1]; ++i)
            if (entry_[i].other == other) return entry_[i].lanes;
        return 0;
    }

private:
    struct Entry {
        Index other;
        std::uint64_t lanes;
    };
    std::vector<Index> start_;  ///< of each block's entries
    std::vector<Entry> entry_;
};

/// Of those, the lanes of the other block that lane l of mine is to be kept from.
[[nodiscard]] inline unsigned of_lane(std::uint64_t lanes, int l) {
    return static_cast<unsigned>(lanes >> (EIGHT * l) & 0xFF);
}

}  // namespace corpuscle::contact
