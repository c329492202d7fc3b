// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gas/flight/facet_blocks.hpp"
#include "gas/grid.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Displacement of a point along each axis without meeting fabric: a lower bound, from a table.
///
/// Facets within `reach` of a cell lie between two parallel planes, low <= normal·x <= high. The
/// absolute components of the normal add up to one, so heights bound displacements: a point moved
/// by w along each axis, and facets moved by d, change their heights by no more than w and d.
///
///     w = min(reach, max(normal·x - high, low - normal·x)) - d
///
/// In a cell without facets w is the reach and all cells between it and the next that holds any.
/// Single precision, from the grid's corner, rounded down.
class Clearance {
public:
    /// From where the facets are, in cells of `edge`; none when `reach` is zero.
    /// @param patches  of the facets, as they were last updated to x or farther
    void build(std::span<const Triangle> triangles, std::span<const Vec3> x,
               const FacetPatches& patches, const Grid& within, double edge, double reach);
    [[nodiscard]] bool is_empty() const { return row_.empty(); }

    /// Clearance at a point, less the facets' displacement since build().                   [m]
    [[nodiscard]] float at(const Vec3& x) const {
        const auto p = small(x);
        const Index row = row_of(p);
        if (row < 0) return free_[-1 - row];
        const SafeSlab& slab = slab_[row];
        const float h = slab.height(p);
        return std::min(reach_, std::max(h - slab.high, slab.low - h));
    }
    /// Whether the straight path between two points is free of facets that have moved by at most
    /// `moved` along each axis. It must be no longer along any than the reach less `moved`.
    [[nodiscard]] bool is_free(const Vec3& from, const Vec3& to, float moved) const {
        const auto p = small(from);
        const Index row = row_of(p);
        if (row < 0) return true;
        const SafeSlab& slab = slab_[row];
        const float h_0 = slab.height(p), h_1 = slab.height(small(to));
        return (std::min(h_0, h_1) > slab.high + moved) | (std::max(h_0, h_1) < slab.low - moved);
    }
    [[nodiscard]] float reach() const { return reach_; }

    /// State for a checkpoint (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(grid_, per_edge_, reach_, row_, slab_, free_);
    }

private:
    struct SafeSlab : Planes {
        [[nodiscard]] float height(const std::array<float, 3>& x) const {
            return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2];
        }
    };
    [[nodiscard]] std::array<float, 3> small(const Vec3& x) const {
        return {static_cast<float>(x[0] - grid_.low[0]), static_cast<float>(x[1] - grid_.low[1]),
                static_cast<float>(x[2] - grid_.low[2])};
    }
    /// A point so near a cell's face that rounding decides is looked up on either side: boxes of
    /// facets are that much wider.
    [[nodiscard]] Index row_of(const std::array<float, 3>& x) const {
        const auto along = [&](int a) {
            return std::clamp(static_cast<int>(x[a] * per_edge_), 0, grid_.count[a] - 1);
        };
        return row_[grid_.row(along(0), along(1), along(2))];
    }
    void number_cells();

    Grid grid_;
    float per_edge_ = 1.0F, reach_ = 0.0F;
    std::vector<Index> row_;      ///< per cell: of its slab, or -1 - cells to the next that has one
    std::vector<SafeSlab> slab_;  ///< of cells with facets within reach
    std::vector<float> free_;     ///< by cells to the next with facets                       [m]
    std::vector<std::uint8_t> off_, off_before_;  ///< per cell
    std::vector<CellRange> range_;                ///< of the facets
    FacetBlocks blocks_;
};

}  // namespace corpuscle::gas
