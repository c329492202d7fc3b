// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "contact/surface/patches.hpp"

namespace corpuscle::contact {

/// Where the nodes of cloth that lies exactly on other cloth have to go so that layers have sides.
///
/// Two triangles coincide where the centroid of one is within 0.1 `lift` of the other and their
/// normals differ by less than 25 degrees, up to the sign. Cloth with normals that look away from
/// each other (a flat bag) parts along them; of cloth with normals that look one way the triangle
/// of the higher row goes along them, the lower against them. A node moves by lift times the mean
/// over all pairs of its triangles, so the layers of a heap keep their order; nodes that both
/// layers have stay.
///
/// @param x  node positions, N × 3                                                          [m]
/// @returns displacements, N × 3; empty where nothing coincides                             [m]
[[nodiscard]] Points lifts_of_coinciding(std::span<const Triangle> triangles,
                                         std::span<const Vec3> x, double lift);

}  // namespace corpuscle::contact
