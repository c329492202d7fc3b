// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "gas/enclosure/bag_walls.hpp"
#include "solver/model.hpp"

namespace corpuscle::tools {

/// Corners of a shell; a triangle's third stands twice.
using Corners = std::array<Vec3, 4>;

/// Area of a shell with these corners: |d1 x d2|/2 of the diagonals.
[[nodiscard]] double area(const Corners& at);

/// Corners of a shell of nodes at x.
[[nodiscard]] Corners corners(const Shell& shell, const Points& x);

/// Does the deck give cloth a shape without stress other than the one at the start?
[[nodiscard]] bool has_references(const Model& model);

/// Area of the shells that close a bag.
/// @param flat  stress-free corners of each shell of the model
[[nodiscard]] double closing_area(const gas::BagWalls& walls, const std::vector<Corners>& flat);

/// Greatest length of a line of the shell over its length without stress.
[[nodiscard]] double greatest_stretch(const Corners& now, const Corners& flat);

}  // namespace corpuscle::tools
