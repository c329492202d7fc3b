// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "contact/broad_phase.hpp"
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
/// Patches of facets and blocks of 8 × 8 × 8 cells are paired by FCL; facets are then entered into
/// the cells that their boxes overlap. Boxes are inflated by `margin`, so the lists serve until a
/// node has moved that far: a rebuild every ten steps or so, whatever the number of particles. They
/// are inflated by `reach`, too: a path no longer than that along each axis only asks the cell it
/// starts in.
class FacetLists {
public:
    FacetLists(std::vector<Triangle> triangles, std::span<const Vec3> x);

    /// Enters every facet, as it moves from x_0 to x_1 and up to `margin` farther.
    void build(const Grid& grid, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
               double margin, double reach = 0.0);

    /// True while no node, at x_1, has left the margin that the lists were built with.
    [[nodiscard]] bool hold_for(std::span<const Vec3> x_1) const;

    [[nodiscard]] const Grid& grid() const { return grid_; }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
    [[nodiscard]] std::span<const Index> nodes() const { return nodes_; }

    /// Facets entered in a cell.
    [[nodiscard]] std::span<const Index> in(std::size_t cell) const {
        return {facet_.data() + start_[cell],
                static_cast<std::size_t>(start_[cell + 1] - start_[cell])};
    }
    [[nodiscard]] std::span<const Index> in(const Slab& slab) const {
        return {facet_.data() + slab.begin, static_cast<std::size_t>(slab.end - slab.begin)};
    }
    [[nodiscard]] double reach() const { return reach_; }  ///< [m]
    [[nodiscard]] bool is_empty(std::size_t cell) const { return start_[cell] == start_[cell + 1]; }
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
    /// visit(slab) for the slabs that the straight way from one point to another does not miss,
    /// until it returns true; did it? One cell for a short way; for a long one all that its box
    /// overlaps.
    template <class Visit>
    bool any_slab(const Vec3& from, const Vec3& to, Visit&& visit) const {
        const auto a = small(from), b = small(to);
        const Vec3 way = (to - from).cwiseAbs();
        if ((way[0] <= reach_) & (way[1] <= reach_) & (way[2] <= reach_)) {
            const Slab& slab = slab_at(a);
            return !slab.is_missed_by(a, b) && visit(slab);
        }
        const bool is_far = way.maxCoeff() > size_;  // single precision would not do
        std::array<int, 3> first, last;
        for (int k = 0; k < 3; ++k) {
            first[k] = grid_.along(k, std::min(from[k], to[k]));
            last[k] = grid_.along(k, std::max(from[k], to[k]));
        }
        for (int k = first[2]; k <= last[2]; ++k)
            for (int j = first[1]; j <= last[1]; ++j)
                for (int i = first[0]; i <= last[0]; ++i) {
                    const Slab& cell = slab(grid_.row(i, j, k));
                    if (cell.begin == cell.end || (!is_far && cell.is_missed_by(a, b))) continue;
                    if (visit(cell)) return true;
                }
        return false;
    }
    /// Does the straight way from one point to another certainly meet no facet?
    [[nodiscard]] bool is_clear(const Vec3& from, const Vec3& to) const {
        return !any_slab(from, to, [](const Slab&) { return true; });
    }
    [[nodiscard]] std::span<const Index> starts() const { return start_; }
    [[nodiscard]] std::span<const Index> facets() const { return facet_; }
    [[nodiscard]] std::size_t builds() const { return builds_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(grid_, margin_, reach_, size_, per_edge_, builds_, built_at_, start_, facet_, slab_,
                slab_row_);
    }

private:
    void pair_patches_with_blocks();
    void find_slabs(std::span<const Vec3> x_0, std::span<const Vec3> x_1);
    template <class Enter>
    void for_each_entry(Enter&& enter) const;

    std::vector<Triangle> triangles_;
    std::vector<Index> nodes_;  ///< rows of the facets' nodes, ascending
    contact::Patches patches_;
    contact::BroadPhase patch_tree_, block_tree_;

    Grid grid_, blocks_;
    double margin_ = -1.0;             ///< negative: never built
    double reach_ = 0.0, size_ = 0.0;  ///< size: longest side of the grid            [m]
    float per_edge_ = 1.0F;
    std::size_t builds_ = 0;
    Points built_at_;  ///< x_1 of the build, for nodes_
    std::vector<contact::Box> facet_box_, box_;
    std::vector<std::pair<Index, Index>> pairs_;  ///< patch, block
    std::vector<Index> start_, fill_, facet_;     ///< cells -> facets, compressed rows
    std::vector<Slab> slab_;       ///< first that of all empty cells, then one a cell
    std::vector<Index> slab_row_;  ///< per cell
    Points normal_;                ///< of the facets, not of unit length
};

}  // namespace corpuscle::gas
