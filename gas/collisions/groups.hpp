// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/collisions/cell_grid.hpp"
#include "gas/flight/facet_lists.hpp"
#include "gas/particles.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// The fabric among particles that are sorted by the grid of its lists.
struct FabricInCells {
    const FacetLists* lists = nullptr;        ///< none: no fabric at all
    std::span<const Vec3> x;                  ///< nodes at the particles' instant            [m]
    std::span<const std::uint8_t> is_open{};  ///< by facet: 1 where it hides nothing; empty: none
};

/// Particles of a cell that see each other: the only ones that may trade momentum and heat.
///
/// A cell without facets is one group. Elsewhere particles on the same side of every facet's plane
/// belong together without further ado; others join where a line of sight between them is free. Two
/// particles of one group are joined by a chain of free lines inside the cell. What cannot be told
/// counts as blocked, so gas that the fabric parts is never mixed, while a group may come out
/// smaller than it might be. Groups depend on ids and places, not on the order of rows nor on
/// threads.
class Groups {
public:
    /// @param reach  longest distance within a cell                                      [m]
    /// The cells' rows are put in the order of groups, and serve until they are sorted again.
    void find(CellSort& cells, const FabricInCells& fabric, const Particles& particles,
              double reach);

    [[nodiscard]] Lists lists() const { return {start_, order_}; }
    [[nodiscard]] std::size_t divided_cells() const { return divided_cells_; }

private:
    void number_groups();

    std::vector<Index> start_;
    std::span<Index> order_;
    std::vector<std::uint8_t> begins_;  ///< does a group begin at this place of order_?
    std::vector<std::size_t> count_;    ///< per chunk
    struct FabricCell {
        std::size_t cell, work;  ///< its number; particles times facets
    };
    parallel::Gathered<FabricCell> found_;
    std::vector<FabricCell> with_fabric_;  ///< cells that several particles and facets are in
    std::size_t divided_cells_ = 0;        ///< that hold more than one group
};

}  // namespace corpuscle::gas
