// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/sheet.hpp"
#include "tools/fold/recipe/recipe.hpp"

namespace corpuscle::fold {

/// Lines that the mesh of a panel must have, so that no fold has to cut it.
struct PlanLines {
    std::vector<double> x, y;  ///< at constant x, at constant y: ascending [m]
};

/// Where the borders of folds along x or y, their bands in `parts` parts, lie in the flat
/// pattern, traced back through those before them. Borders that lie in the bend of another fold are
/// left out: cutting finds them.
[[nodiscard]] PlanLines plan_lines(const std::vector<Move>& folds, double gap, int parts);

/// What a cell of a panel is; vent i is VENT + i.
enum Region { CLOTH = 0, HOLE = 1, RING = 2, VENT = 3 };

/// The rectangle that a tether covers, along the axes.
struct TetherStrip {
    Vec3 low, high;  ///< corners [m]
    explicit TetherStrip(const Tether& tether);
};

/// Flat meshes of a disc or a rectangle: quads on the lines and between them, the rim imprinted.
/// Nodes of the same row are at the same place but for those that holes have drawn near.
struct Plan {
    Sheet front, back;  ///< with their holes, ring and vents; `part` is the Region
    Sheet between;      ///< for tethers: without
};

/// @param is_alike  panels and tethers get the holes of all, so that meshes of layers match
/// @throws InputError if a hole, a vent or a tether is not within the pattern
[[nodiscard]] Plan make_plan(const Recipe& recipe, const PlanLines& lines, bool is_alike);

}  // namespace corpuscle::fold
