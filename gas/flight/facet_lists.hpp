// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "gas/flight/block_of_cells.hpp"
#include "gas/flight/clearance.hpp"
#include "gas/flight/facet_blocks.hpp"
#include "gas/flight/facet_eights.hpp"
#include "gas/grid.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// What a cell holds: its facets lie between two parallel planes, low <= normal·x <= high, while
/// the lists hold. A path that stays above or below meets none of them; in a cell without facets
/// every path does. Single precision, from the grid's corner, rounded outward.
struct Slab {
    std::array<float, 3> normal{0.0F, 0.0F, 0.0F};  ///< of unit length
    float low = 1.0F, high = -1.0F;                 ///< [m]
    Index begin = 0, end = 0;                       ///< of the cell's list

    [[nodiscard]] bool is_missed_by(const std::array<float, 3>& from,
                                    const std::array<float, 3>& to) const {
        const float h_0 = height(from), h_1 = height(to);
        return (std::min(h_0, h_1) > high) | (std::max(h_0, h_1) < low);
    }
    [[nodiscard]] float height(const std::array<float, 3>& x) const {
        return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2];
    }
};

/// Which facets a particle may meet in each grid cell.
///
/// FCL finds the patches of facets near each block of some cells (facet_blocks.hpp); facets are then
/// entered into the cells that their boxes overlap. Boxes are inflated by `margin`, so the lists
/// serve until a node has moved that far: a rebuild every ten steps or so, whatever the number of
/// particles. With a `reach` there is a table of safe distances, too, up to some cells and that
/// (clearance.hpp).
class FacetLists {
public:
    /// A cell's list is one of its facets, or of the eights that have facets in it.
    enum class Of : std::uint8_t { FACETS, EIGHTS };

    FacetLists(std::vector<Triangle> triangles, std::span<const Vec3> x, Of of);

    /// Enters every facet, as it moves from x_0 to x_1 and up to `margin` farther.
    void build(const Grid& grid, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
               double margin, double reach = 0.0);

    /// True while no node, at x_1, has left the margin that the lists were built with.
    [[nodiscard]] bool hold_for(std::span<const Vec3> x_1) const;

    [[nodiscard]] const Grid& grid() const { return grid_; }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    [[nodiscard]] std::span<const Index> nodes() const { return nodes_; }

    /// Facets entered in a cell (of FACETS).
    [[nodiscard]] std::span<const Index> in(std::size_t cell) const { return in(slab(cell)); }
    [[nodiscard]] std::span<const Index> in(const Slab& slab) const {
        return {facet_.data() + slab.begin, static_cast<std::size_t>(slab.end - slab.begin)};
    }
    /// Eights with facets in cells, by eight, slab after slab (of EIGHTS); -1: no more in a cell.
    using EightEights = std::array<Index, EIGHT>;
    [[nodiscard]] std::span<const EightEights> eights_in() const { return eights_in_; }
    [[nodiscard]] const FacetEights& eights() const { return eights_; }
    /// visit(facet) for those of a cell; of EIGHTS: for some beyond, too.
    template <class Visit>
    void for_each_in(const Slab& slab, Visit&& visit) const {
        if (of_ == Of::FACETS)
            for (const Index facet : in(slab)) visit(facet);
        else
            for (Index k = slab.begin; k < slab.end; ++k)
                for (const Index eight : eights_in_[k])
                    if (eight >= 0)
                        for (const Index facet : eights_.facet[eight])
                            if (facet >= 0) visit(facet);
    }
    [[nodiscard]] bool is_empty(std::size_t cell) const { return slab_row_[cell] == 0; }
    [[nodiscard]] const Slab& slab(std::size_t cell) const { return slab_[slab_row_[cell]]; }

    /// A point as slabs take it.
    [[nodiscard]] std::array<float, 3> small(const Vec3& x) const {
        return {static_cast<float>(x[0] - grid_.low[0]), static_cast<float>(x[1] - grid_.low[1]),
                static_cast<float>(x[2] - grid_.low[2])};
    }
    /// Slab of the cell that a point is in. (A point so near a cell's face that rounding decides
    /// finds the same facets on both sides.)
    [[nodiscard]] const Slab& slab_at(const std::array<float, 3>& x) const {
        const auto along = [&](int a) {
            return std::clamp(static_cast<int>(x[a] * per_edge_), 0, grid_.count[a] - 1);
        };
        return slab(grid_.row(along(0), along(1), along(2)));
    }
    /// visit(slab, from_share, to_share) for the slabs that the straight way from one point to
    /// another does not miss, in the order in which it comes to their cells, with the shares of the
    /// way at which it enters and leaves; until it returns true: did it?
    template <class Visit>
    bool any_slab(const Vec3& from, const Vec3& to, Visit&& visit) const {
        const double far = (to - from).cwiseAbs().maxCoeff() / size_;
        if (far <= 1.0) return any_slab_near(from, to, visit);
        constexpr double MOST_PIECES = 10000.0;  // of the grid's size: a way of no sense
        return far <= MOST_PIECES ? any_slab_in_pieces(from, to, std::ceil(far), visit)
                                  : any_slab_in_box(from, to, visit);
    }
    /// Whether a short straight way is free of facets as long as the lists hold for them; false where
    /// that is not known.
    [[nodiscard]] bool is_clear(const Vec3& from, const Vec3& to) const {
        return !clearance_.is_empty() &&
               clearance_.at(from) > (to - from).cwiseAbs().maxCoeff() + margin_;
    }
    /// How far particles may fly before these facets can be in their way.
    [[nodiscard]] const Clearance& clearance() const { return clearance_; }
    /// Farthest that a node has moved along an axis since the lists were built.              [m]
    [[nodiscard]] double displacement(std::span<const Vec3> x_0, std::span<const Vec3> x_1) const;
    /// The same from the build before the last to the last.                                  [m]
    [[nodiscard]] double moved_between_builds() const { return moved_between_builds_; }
    [[nodiscard]] std::size_t builds() const { return builds_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(grid_, margin_, size_, per_edge_, builds_, built_at_, facet_, eights_in_, slab_,
                slab_row_, clearance_);
    }

private:
    /// visit(cell, enters, leaves) for the cells that a way passes through, in order, with the
    /// shares of the way [Amanatides & Woo 1987], until it returns true.
    template <class Visit>
    bool walk(const Vec3& from, const Vec3& to, Visit&& visit) const {
        std::array<int, 3> cell, end, step;
        std::array<double, 3> at, next, per_cell;
        int steps = 0;
        for (int a = 0; a < 3; ++a) {
            const double p = (from[a] - grid_.low[a]) * grid_.per_edge,
                         q = (to[a] - grid_.low[a]) * grid_.per_edge;
            cell[a] = static_cast<int>(std::floor(p));
            end[a] = static_cast<int>(std::floor(q));
            step[a] = end[a] > cell[a] ? 1 : -1;
            steps += std::abs(end[a] - cell[a]);
            at[a] = p;
            per_cell[a] = std::abs(q - p);
        }
        const auto along = [&](int a) { return std::clamp(cell[a], 0, grid_.count[a] - 1); };
        if (steps == 0) return visit(grid_.row(along(0), along(1), along(2)), 0.0, 1.0);
        for (int a = 0; a < 3; ++a) {
            per_cell[a] = 1.0 / per_cell[a];
            const double face = cell[a] + (step[a] > 0 ? 1.0 : 0.0);
            next[a] = cell[a] == end[a] ? INF : std::abs(face - at[a]) * per_cell[a];
        }
        double enters = 0.0;
        for (int i = 0;; ++i) {
            const int a =
                next[0] < next[1] ? (next[0] < next[2] ? 0 : 2) : (next[1] < next[2] ? 1 : 2);
            const double leaves = i == steps ? 1.0 : std::min(next[a], 1.0);
            if (visit(grid_.row(along(0), along(1), along(2)), enters, leaves)) return true;
            if (i == steps) return false;
            enters = leaves;
            cell[a] += step[a];
            next[a] = cell[a] == end[a] ? INF : next[a] + per_cell[a];
        }
    }

    template <class Visit>
    bool any_slab_near(const Vec3& from, const Vec3& to, Visit&& visit) const {
        const auto a = small(from), b = small(to);
        return walk(from, to, [&](std::size_t cell, double enters, double leaves) {
            const Slab& here = slab(cell);
            return here.begin != here.end && !here.is_missed_by(a, b) &&
                   visit(here, enters, leaves);
        });
    }

    /// For ways longer than the grid, where single precision would not do: piece by piece.
    template <class Visit>
    bool any_slab_in_pieces(const Vec3& from, const Vec3& to, double pieces, Visit&& visit) const {
        const auto at = [&](double k) { return Vec3(from + k / pieces * (to - from)); };
        for (double k = 0.0; k < pieces; ++k)
            if (any_slab_near(at(k), at(k + 1.0), [&](const Slab& slab, double in, double out) {
                    return visit(slab, (k + in) / pieces, (k + out) / pieces);
                }))
                return true;
        return false;
    }

    /// All cells that the way's box overlaps, in any order.
    template <class Visit>
    bool any_slab_in_box(const Vec3& from, const Vec3& to, Visit&& visit) const {
        std::array<int, 3> first, last;
        for (int k = 0; k < 3; ++k) {
            first[k] = grid_.along(k, std::min(from[k], to[k]));
            last[k] = grid_.along(k, std::max(from[k], to[k]));
        }
        for (int k = first[2]; k <= last[2]; ++k)
            for (int j = first[1]; j <= last[1]; ++j)
                for (int i = first[0]; i <= last[0]; ++i) {
                    const Slab& cell = slab(grid_.row(i, j, k));
                    // Nothing is known of the order: each is told that the way ends nowhere in it.
                    if (cell.begin != cell.end && visit(cell, 0.0, 0.0)) return true;
                }
        return false;
    }

    void fill(const FacetBlocks::Block& at, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
              BlockOfCells& block);
    std::size_t list_eights(int cell, const BlockOfCells& block, std::size_t to);

    std::vector<Triangle> triangles_;
    std::vector<Index> nodes_;  ///< rows of the facets' nodes, ascending
    FacetPatches patches_;
    FacetEights eights_;
    Of of_;

    Grid grid_;
    double margin_ = -1.0;  ///< negative: never built
    double size_ = 0.0;     ///< longest side of the grid                  [m]
    float per_edge_ = 1.0F;
    std::size_t builds_ = 0;
    double moved_between_builds_ = INF;  ///< [m]
    Points built_at_;                    ///< x_1 of the build, for nodes_
    std::vector<CellRange> range_;       ///< of the facets
    FacetBlocks blocks_;
    std::vector<Index> facet_;            ///< cell after cell, block after block
    std::vector<EightEights> eights_in_;  ///< likewise
    std::vector<Slab> slab_;              ///< first that of all empty cells, then one a cell
    std::vector<Index> slab_row_;         ///< per cell
    Clearance clearance_;
};

}  // namespace corpuscle::gas
