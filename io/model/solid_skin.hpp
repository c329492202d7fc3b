// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "io/model/draft.hpp"

/// Rigid parts that are meshed with solids: only their skin and their mass matter.
namespace corpuscle::io {

/// Faces of a solid, outward: 1 to 6, each with nodes by node row, a triangle repeating its 3rd.
///
/// The eight nodes are a brick's (1-4 seen counter-clockwise from 5-8), a wedge's (5 = 6, 7 = 8),
/// a pyramid's (5 = 6 = 7 = 8) or a tetrahedron's (4 = 5 = 6 = 7 = 8).
std::vector<std::array<Index, 4>> faces_of(const std::array<Index, 8>& solid);

/// Volume, first and second moment about the origin of what closed facets enclose.
struct Bulk {
    double volume = 0.0;         ///< [m^3]
    double area = 0.0;           ///< of the facets                       [m^2]
    Vec3 first = Vec3::Zero();   ///< integral of x                       [m^4]
    Mat3 second = Mat3::Zero();  ///< integral of x xᵀ                    [m^5]

    void add(const Vec3& a, const Vec3& b, const Vec3& c);
};
/// Of facets whose corners are seen from `origin`.
Bulk bulk_of(const std::vector<std::array<Index, 4>>& facets, const Points& x, const Vec3& origin);

/// Gives every part of solids its skin as shells, numbered on from the highest element id, in the
/// order of the solids; its mass, centre and inertia, unless *PART_INERTIA says them; and the nodes
/// inside as nodes that ride on it. The shells get the thickness that has the solids' mass,
/// and for contact that of the thinnest shells of the deck.
void make_skins(Draft& draft);

}  // namespace corpuscle::io
