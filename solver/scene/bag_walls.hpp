// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "gas/outflow/openings.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// The facets that enclose a bag's gas, and those inside it, in triangles, with their parts. Pairs
/// of closing facets that have all three nodes in common, as in the corner of a flat bag whose
/// panels share their rim, enclose nothing: with Model::closes_bags they are left out where edges
/// would else belong to four facets.
/// @param reference  corners of each shell in its reference shape                           [m]
[[nodiscard]] gas::BagWalls bag_walls(const Model& model, const gas::BagCard& card,
                                      const std::vector<std::array<Vec3, 4>>& reference);

/// Likewise of a bag of uniform pressure.
[[nodiscard]] gas::BagWalls bag_walls(const Model& model, const gas::UniformBagCard& card);

}  // namespace corpuscle
