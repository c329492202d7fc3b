// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
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
    explicit TrianglePairs(const Patches& patches);

    /// Takes the triangles' boxes, one each, and pairs the patches.
    void update(std::span<const Box> triangle_boxes);

    /// Patch pairs p <= q, sorted, each patch also with itself.
    [[nodiscard]] std::span<const std::pair<Index, Index>> patch_pairs() const { return pairs_; }

    /// meet(a, b) for every pair of triangles in a pair of patches whose boxes overlap (to within
    /// the rounding of a float), each once.
    template <class Meet>
    void for_each_in(const std::pair<Index, Index>& patch_pair, Meet&& meet) const {
        const auto [p, q] = patch_pair;
        const Bounds other = patch_bounds_[q];
        for (Index i = patches_.start[p]; i < patches_.start[p + 1]; ++i) {
            const Bounds mine = bounds(i);
            if (!mine.overlaps(other)) continue;
            const Index end = patches_.start[q + 1];
            for (Index j = p == q ? i + 1 : patches_.start[q]; j < end; j += BLOCK)
                meet_block(i, mine, j, std::min(BLOCK, end - j), meet);
        }
    }

private:
    static constexpr Index BLOCK = 64;
    [[nodiscard]] Bounds bounds(Index i) const {
        return {{low_[0][i], low_[1][i], low_[2][i]}, {high_[0][i], high_[1][i], high_[2][i]}};
    }
    template <class Meet>
    void meet_block(Index i, const Bounds& mine, Index first, Index n, Meet&& meet) const {
        std::array<std::uint8_t, BLOCK> is_hit;
        const float *lx = &low_[0][first], *ly = &low_[1][first], *lz = &low_[2][first];
        const float *hx = &high_[0][first], *hy = &high_[1][first], *hz = &high_[2][first];
        for (Index j = 0; j < n; ++j)  // a loop that compilers turn into vector instructions
            is_hit[j] = (lx[j] <= mine.high[0]) & (ly[j] <= mine.high[1]) &
                        (lz[j] <= mine.high[2]) & (mine.low[0] <= hx[j]) & (mine.low[1] <= hy[j]) &
                        (mine.low[2] <= hz[j]);
        for (Index j = 0; j < n; ++j)
            if (is_hit[j]) meet(patches_.triangle[i], patches_.triangle[first + j]);
    }

    void set_bounds(Index i, const Box& box);

    const Patches& patches_;
    BroadPhase tree_;
    std::array<std::vector<float>, 3> low_, high_;  ///< of triangles, in the patches' order  [m]
    std::vector<Box> patch_box_;
    std::vector<Bounds> patch_bounds_;
    std::vector<std::pair<Index, Index>> pairs_;
};

}  // namespace corpuscle::contact
