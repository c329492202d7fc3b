// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/geometry/box.hpp"
#include "solver/base/surface.hpp"

/// The plain way, kept as the oracle that the quick one is held to.
namespace corpuscle::contact::brute_force {

/// All overlapping pairs i < j, sorted.
[[nodiscard]] std::vector<std::pair<Index, Index>> self_pairs(std::span<const Box> boxes);

/// All pairs i < j of triangles without a common node that cross, sorted.
[[nodiscard]] std::vector<std::pair<Index, Index>> crossings(std::span<const Triangle> triangles,
                                                             std::span<const Vec3> x);

}  // namespace corpuscle::contact::brute_force
