// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <vector>

#include "contact/culling/charts.hpp"
#include "contact/culling/patch_motion.hpp"
#include "contact/culling/spread.hpp"

namespace corpuscle::contact {

/// How far it is looked ahead: so many steps like the one that was foreseen, at least some way.
struct Lookahead {
    double steps;
    double least = 0.0;  ///< [m]

    [[nodiscard]] double of(Index patch, const PatchMotion& motion) const {
        return std::max(steps * motion.ahead(patch).flutter, least);
    }
};

/// visit(i) for each bit i that is set, ascending.
template <class Visit>
void for_each_bit(std::uint64_t bits, Visit&& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

/// Until which flutter of its patch each sheet of each chart is spread enough. A way of d changes
/// the gradient of a triangle of least height h by 2 d / h at most, so what a look finds holds for
/// a while.
class SheetLimits {
public:
    explicit SheetLimits(const Charts& charts);

    /// Two edges of the triangles of a patch, worked out once they are asked for.
    class Edges {
    public:
        Edges(std::span<const Charts::Block> blocks, const Points& x) : blocks_(blocks), x_(x) {}
        const EightEdges& operator[](std::size_t block);

    private:
        std::span<const Charts::Block> blocks_;
        const Points& x_;
        std::array<EightEdges, Charts::MOST_BLOCKS> edges_;
        std::array<bool, Charts::MOST_BLOCKS> is_known_{};
    };

    /// Forgets what it has seen: the cloth has moved unseen.
    void forget();

    /// Looks at a patch as a sheet of a chart: at the blocks whose limits are below `soon`, or not
    /// known. The patch's shape is marked (patch_motion.hpp).
    void look(Index patch, const Charts::Place& at, double soon, Edges& edges,
              const PatchMotion& motion);

    /// Turns a chart to where its own patch lies now: Q = G (G^T G)^-1/2 of its mean gradient, each
    /// triangle's by its area. Looks at these of its sheets, whose patches' shapes are marked, and
    /// forgets the others: what was seen from elsewhere says nothing any more.
    void turn(Index chart, std::uint64_t sheets, const Points& x, const PatchMotion& motion);

    /// Whether a sheet of a patch, given by its row, is spread enough for less than that.
    [[nodiscard]] bool is_short(Index row, Index patch, const Lookahead& ahead,
                                const PatchMotion& motion) const {
        return motion.gone(patch).flutter + ahead.of(patch, motion) > limit_[row];
    }
    /// Those of some of a chart's sheets that are.
    [[nodiscard]] std::uint64_t short_of(Index chart, std::uint64_t sheets, const Lookahead& ahead,
                                         const PatchMotion& motion) const;

    [[nodiscard]] double operator[](Index row) const { return limit_[row]; }  ///< [m]

    /// How far nodes may move until some of these sheets are not spread enough, looked at anew; a
    /// number below 0 where they are not now.                                               [m]
    [[nodiscard]] double spare(Index chart, std::uint64_t sheets, const Points& x) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(limit_, block_limit_, frame_);
    }

private:
    [[nodiscard]] double look_at_block(const Spread& spread, Index patch, std::uint64_t crossed,
                                       std::size_t block, Edges& edges) const;

    const Charts& charts_;
    std::vector<double> limit_;        ///< by row                                      [m]
    std::vector<double> block_limit_;  ///< by row and block                            [m]
    std::vector<Frame> frame_;         ///< by chart: Q
};

}  // namespace corpuscle::contact
