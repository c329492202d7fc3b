// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "contact/broad_phase.hpp"
#include "gas/grid.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Box in single precision, rounded outward: enough to tell what cannot meet, in half the memory.   [m]
struct SmallBox {
    std::array<float, 3> low, high;

    SmallBox() = default;
    explicit SmallBox(const contact::Box& box) {
        for (int a = 0; a < 3; ++a) {
            low[a] = std::nextafter(static_cast<float>(box.low[a]), -HUGE_VALF);
            high[a] = std::nextafter(static_cast<float>(box.high[a]), HUGE_VALF);
        }
    }
    [[nodiscard]] bool overlaps(const SmallBox& o) const {
        bool apart = false;  // no early exit: six comparisons are cheaper than one wrong guess
        for (int a = 0; a < 3; ++a) apart |= (low[a] > o.high[a]) | (o.low[a] > high[a]);
        return !apart;
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
    /// Boxes that the facets of in(cell) stay in while the lists hold, in the same order.
    [[nodiscard]] std::span<const SmallBox> boxes_in(std::size_t cell) const {
        return {entry_box_.data() + start_[cell], in(cell).size()};
    }
    [[nodiscard]] std::span<const Index> starts() const { return start_; }
    [[nodiscard]] std::span<const Index> facets() const { return facet_; }
    [[nodiscard]] std::size_t builds() const { return builds_; }

private:
    void pair_patches_with_blocks();
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
    std::vector<SmallBox> entry_box_;             ///< of facet_, so that a cell reads straight on
    std::vector<Index> start_, fill_, facet_;     ///< cells -> facets, compressed rows
};

}  // namespace corpuscle::gas
