// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/geometry/distance.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// How far the nearest places of a pair are the nearest of the cloth round them.
///
/// Let n point from a place to the other one, and u, of length one, from the edge or node that it
/// lies on into a triangle that has it, or along an edge. Where n · u > 0 the cloth beside the place
/// is nearer: it has a contact of its own, and this one would push along the sheet. So it gives
///
///     1 where the greatest n · u <= 0, 0 from 0.02 on, linear between
///
/// of the pressure. A node facing a triangle's inside has 1. Cloth beside a place counts only if a
/// card that is on has it touch the other place.
///
/// Source: the Voronoi regions of a surface's faces, edges and nodes [Ericson 2005, 5.1.5], softened.
/// @param parts  by which the places touch
/// @param x      node positions, N × 3                                                   [m]
/// @param gap    between the places, above 0                                              [m]
/// @returns 0 to 1                                                                        [-]
[[nodiscard]] double exposure(const Cloth& cloth, PartPair parts, const Points& x, const Pair& pair,
                              const Nearest& places, double gap);

}  // namespace corpuscle::contact
