// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/broad_phase.hpp"

namespace corpuscle::contact {

/// Pairs of triangles that may be close: FCL pairs the patches, and the triangles of a pair of
/// patches are compared box by box.
class TrianglePairs {
public:
    explicit TrianglePairs(const Patches& patches);

    /// Takes the triangles' boxes, one each, and pairs the patches.
    void update(std::span<const Box> triangle_boxes);

    /// Patch pairs p <= q, sorted, each patch also with itself.
    [[nodiscard]] std::span<const std::pair<Index, Index>> patch_pairs() const { return pairs_; }

    /// meet(a, b) for every pair of triangles in a pair of patches whose boxes overlap, each once.
    template <class Meet>
    void for_each_in(const std::pair<Index, Index>& patch_pair, Meet&& meet) const {
        const auto [p, q] = patch_pair;
        const auto mine = patches_[p], theirs = patches_[q];
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const Box& box = boxes_[mine[i]];
            if (!box.overlaps(patch_box_[q])) continue;
            for (std::size_t j = p == q ? i + 1 : 0; j < theirs.size(); ++j)
                if (box.overlaps(boxes_[theirs[j]])) meet(mine[i], theirs[j]);
        }
    }

private:
    const Patches& patches_;
    BroadPhase tree_;
    std::span<const Box> boxes_;
    std::vector<Box> patch_box_;
    std::vector<std::pair<Index, Index>> pairs_;
};

}  // namespace corpuscle::contact
