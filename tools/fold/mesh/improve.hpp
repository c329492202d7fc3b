// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>

#include "tools/fold/pattern/sheet.hpp"

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

/// Which edges are short, and what stands in the way.
struct ShortEdges {
    double too_small;    ///< cells whose reach is more are left alone                     [m]
    double slack = 0.0;  ///< how far a straight line may be moved                         [m]
    std::vector<char> is_seam{};  ///< by node: do panels meet there? Empty: only the sheet's rim is
};

/// Draws short edges together where the least reach of all cells that this changes becomes greater.
/// A node goes to another that is on all of its lines, or nearer than the slack.
/// @returns  how many
int collapse(const ShortEdges& edges, const Freedom& freedom, Sheet& sheet);

}  // namespace corpuscle::fold
