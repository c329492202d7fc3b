// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/surface/patches.hpp"

namespace corpuscle::contact {

/// Pairs of triangles without a common node that cross: an edge of one passes through the inside of
/// the other. Signs are exact, so the answer is the truth about the given coordinates; touching is
/// not crossing.
///
/// @param patches  of the same triangles
/// @param x        node positions, N × 3                                                [m]
/// @returns triangle rows i < j, sorted
[[nodiscard]] std::vector<std::pair<Index, Index>> crossings(std::span<const Triangle> triangles,
                                                             const Patches& patches,
                                                             std::span<const Vec3> x);

}  // namespace corpuscle::contact
