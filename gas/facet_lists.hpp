// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/broad_phase.hpp"
#include "gas/grid.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Where the facets of a cell lie: between two parallel planes, low <= normal·x <= high, while the
/// lists hold. A path that stays above or below meets none of them.
struct Slab {
    Vec3 normal = Vec3::Zero();     ///< of unit length
    double low = -INF, high = INF;  ///< [m]

    [[nodiscard]] bool is_missed_by(const Vec3& from, const Vec3& to) const {
        const double h_0 = normal.dot(from), h_1 = normal.dot(to);
        return std::min(h_0, h_1) > high || std::max(h_0, h_1) < low;
    }
};

/// Which facets a particle may meet in each grid cell.
///
/// Patches of facets and blocks of 8 × 8 × 8 cells are paired by FCL; facets are then entered into
/// the cells that their boxes overlap. Boxes are inflated by `margin`, so the lists serve until a
/// node has moved that far: a rebuild every ten steps or so, whatever the number of particles.
class FacetLists {
public:
    FacetLists(std::vector<Triangle> triangles, std::span<const Vec3> x);

    /// Enters every facet, as it moves from x_0 to x_1 and up to `margin` farther.
    void build(const Grid& grid, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
               double margin);

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
    /// How far the nearest cell with facets is, in cells along the farthest axis; 0: facets here.
    /// At most FAR.
    [[nodiscard]] int clear(std::size_t cell) const { return clear_[cell]; }
    static constexpr int FAR = 3;

    [[nodiscard]] const Slab& slab(std::size_t cell) const { return slab_[cell]; }
    [[nodiscard]] std::span<const Index> starts() const { return start_; }
    [[nodiscard]] std::span<const Index> facets() const { return facet_; }
    [[nodiscard]] std::size_t builds() const { return builds_; }

private:
    void pair_patches_with_blocks();
    void measure_clearance();
    void find_slabs(std::span<const Vec3> x_0, std::span<const Vec3> x_1);
    template <class Enter>
    void for_each_entry(Enter&& enter) const;

    std::vector<Triangle> triangles_;
    std::vector<Index> nodes_;  ///< rows of the facets' nodes, ascending
    contact::Patches patches_;
    contact::BroadPhase patch_tree_, block_tree_;

    Grid grid_, blocks_;
    double margin_ = -1.0;  ///< negative: never built
    std::size_t builds_ = 0;
    Points built_at_;  ///< x_1 of the build, for nodes_
    std::vector<contact::Box> facet_box_, box_;
    std::vector<std::pair<Index, Index>> pairs_;  ///< patch, block
    std::vector<Index> start_, fill_, facet_;     ///< cells -> facets, compressed rows
    std::vector<std::uint8_t> clear_, wider_;     ///< per cell
    std::vector<Slab> slab_;                      ///< per cell
    Points normal_;                               ///< of the facets, not of unit length
};

}  // namespace corpuscle::gas
