// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>

#include "tools/fold/sheet.hpp"

namespace corpuscle::fold {

/// How far apart a triangle's corners are, as its highest frequency feels it:
///
///     (3 · Σ |∇N_i|²)^-½  over its corners
///
/// Of a quad: that of the least triangle at a corner, times the square root of 3/2, which makes a
/// rectangle's (4 · Σ |∇N_i|²)^-½. The stable step is some 2 reach / c. A square of side a has
/// 0.354 a, its half 0.289 a. Negative where the cell is inside out or without area.          [m]
[[nodiscard]] double reach(const Cell& cell, const Points& X);

/// What may move when a mesh is improved.
struct Freedom {
    std::map<int, std::function<void(Vec3& X)>> curves;  ///< by name: moves a point onto it; nodes
                                                         ///< on other curves stay
    std::function<bool(const Vec3& X)> is_free;          ///< empty: everywhere
};

/// Moves nodes to where the least reach of their cells is greater: free ones anywhere, those on a
/// line along it. Nodes whose cells have more than `wanted` stay.                               [m]
void smooth(Sheet& sheet, double wanted, int rounds, const Freedom& freedom);

/// Draws short edges together, where no line has to move for it and the least reach of all cells
/// that it changes becomes greater. A node goes to another that is on all of its lines.
/// @param too_small  cells with more than this are left alone [m]
/// @returns  how many
int collapse_short_edges(Sheet& sheet, double too_small, const Freedom& freedom);

}  // namespace corpuscle::fold
