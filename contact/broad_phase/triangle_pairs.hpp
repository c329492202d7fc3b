// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <span>
#include <utility>
#include <vector>

#include "contact/broad_phase/bounds.hpp"
#include "contact/broad_phase/broad_phase.hpp"

namespace corpuscle::contact {

/// Pairs of triangles that may be close: FCL pairs the patches, and the triangles of a pair of
/// patches are compared box by box.
class TrianglePairs {
public:
    /// @param patches  of the triangles
    /// @param x        node positions, N × 3                                                 [m]
    /// @param margin   by which their boxes are wider on each side                           [m]
    TrianglePairs(const Patches& patches, std::span<const Triangle> triangles,
                  std::span<const Vec3> x, double margin);

    /// Patch pairs p <= q, sorted, each patch also with itself.
    [[nodiscard]] std::span<const std::pair<Index, Index>> patch_pairs() const { return pairs_; }

    /// meet(a, b) for every pair of triangles in a pair of patches whose boxes overlap (to within
    /// the rounding of a float), each once.
    template <class Meet>
    void for_each_in(const std::pair<Index, Index>& patch_pair, Meet&& meet) const {
        const auto [p, q] = patch_pair;
        const auto mine = patches_[p], others = patches_[q];
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const Bounds box = bounds_[p][i / EIGHT][static_cast<int>(i % EIGHT)];
            for (std::size_t b = 0; b < bounds_[q].size(); ++b)
                for (unsigned bits = bounds_[q][b].overlapping(box); bits != 0; bits &= bits - 1) {
                    const auto j = EIGHT * b + static_cast<std::size_t>(std::countr_zero(bits));
                    if (p != q || i < j) meet(mine[i], others[j]);
                }
        }
    }

private:
    const Patches& patches_;
    std::vector<std::vector<EightBounds>> bounds_;  ///< of each patch's triangles             [m]
    std::vector<std::pair<Index, Index>> pairs_;
};

}  // namespace corpuscle::contact
