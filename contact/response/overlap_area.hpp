// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"

namespace corpuscle::contact {

struct ContactArea {
    double area;  ///< that the contact stands for, above 0                               [m^2]
    double own;   ///< of the lesser of its places: a third of the triangles round it     [m^2]
};

/// Area of cloth that a contact stands for, so that a pressure-thickness law gives the same
/// pressure on any mesh.
///
/// Seen along the contact's normal, the triangles of its two places overlap in convex polygons, of
/// which the place is a corner: a node in a triangle, or where two edges cross. A polygon of area S
/// shares itself out to its corners k,
///
///     A_k = (S_k-1 + S_k + lambda_k S) / 3,   lambda_k = (l_k-1 + l_k) / (2 sum of l),
///
/// l_k its sides, S_k their triangles with g = sum of lambda_k x_k, which makes sum of A_k f(x_k) the
/// integral of any linear f. So contacts of flat sheets press each node of either sheet with
/// just what a uniform pressure does, wherever the meshes lie (patch test; the idea of mortar
/// contact [Puso & Laursen 2004]), and areas change evenly as sheets slide.
///
/// Where the triangles of a place stand steep, as at a rim on a body, little overlaps: a contact has at
/// least STEEP (1 - c) of the lesser place's own area, c the lesser cosine to the normal.
/// @param x  node positions, N × 3                                                        [m]
[[nodiscard]] ContactArea overlap_area(const Cloth& cloth, const Points& x, const Contact& contact);

}  // namespace corpuscle::contact
