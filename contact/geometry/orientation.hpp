// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>

#include "solver/base/predicates.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::contact {

/// Side of the plane a b c on which d lies: exact sign of |b-a c-a d-a|, positive where the normal
/// points.
///
/// cost: 9 differences and one determinant; exact arithmetic on the coordinates themselves only
/// where rounding could have turned the sign [Shewchuk 1997, orient3d]
[[nodiscard]] int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Whether the open segment p q passes through the inside of triangle a b c. Touching is not
/// crossing.
[[nodiscard]] bool segment_crosses(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b,
                                   const Vec3& c);

/// Whether an edge of one triangle passes through the inside of the other.
[[nodiscard]] bool triangles_cross(const Triangle& first, const Triangle& second,
                                   std::span<const Vec3> x);

[[nodiscard]] inline bool share_node(const Triangle& a, const Triangle& b) {
    for (const Index i : a)
        for (const Index j : b)
            if (i == j) return true;
    return false;
}

}  // namespace corpuscle::contact
