// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

#include "solver/base/surface.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fold {

using Cell = std::array<Index, 4>;  ///< node rows; a triangle repeats its 3rd

[[nodiscard]] inline int corner_count(const Cell& c) {
    return c[2] == c[3] ? 3 : 4;
}

/// Cloth as a mesh: where its nodes are, and where they were when it was flat.
struct Sheet {
    Points X;                 ///< flat pattern, N × 3                               [m]
    Points x;                 ///< now, N × 3                                        [m]
    std::vector<Cell> cells;  ///< E × 4
    std::vector<int> part;    ///< E, whatever the owner counts as a part

    /// Lines that must stay where they are, by node: a node moves along these at most.
    std::vector<std::vector<int>> on;  ///< N, ascending names of lines
};

/// Whether a line through `a`'s node goes through `b`'s too, for all of a's lines.
[[nodiscard]] bool is_within(const std::vector<int>& a, const std::vector<int>& b);

/// Edges of all cells, rows ascending, each once, sorted.
[[nodiscard]] std::vector<std::pair<Index, Index>> edges(const std::vector<Cell>& cells);

/// Edges that just one cell has.
[[nodiscard]] std::vector<std::pair<Index, Index>> rim_edges(const std::vector<Cell>& cells);

/// Two triangles of a quad, cut from its first corner to its third; one of a triangle.
[[nodiscard]] std::vector<Triangle> triangles(const std::vector<Cell>& cells);

/// Least sine of a corner's angle, negative or zero where a cell is inside out or without area.
[[nodiscard]] double quality(const Cell& cell, const Points& X);

[[nodiscard]] double area(const Cell& cell, const Points& X);  ///< [m^2]

/// A polygon of 3 to 5 corners as triangles and quads, of all ways the one of the best quality.
/// @throws InputError  for another number of corners
[[nodiscard]] std::vector<Cell> best_cells(const std::vector<Index>& polygon, const Points& X);

/// Drops nodes that no cell has, from sets of nodes too.
void drop_loose_nodes(Sheet& sheet, const std::vector<std::vector<Index>*>& sets = {});

}  // namespace corpuscle::fold
