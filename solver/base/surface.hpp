// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "solver/base/vec.hpp"

namespace corpuscle {

/// Three node rows; the normal is (x1 - x0) × (x2 - x0).
using Triangle = std::array<Index, 3>;

/// Triangles whose nodes move linearly from x_0 to x_1 during a step: all that gas and contact see
/// of a scene. Quads appear as two triangles; `shell` names the element that a triangle was cut
/// from.
struct Surface {
    std::span<const Vec3> x_0;            ///< node positions at t, N × 3                 [m]
    std::span<const Vec3> x_1;            ///< node positions at t + dt, N × 3            [m]
    std::span<const Triangle> triangles;  ///< T × 3 node rows
    std::span<const Index> shell;         ///< T shell rows
};

/// Vector area (half the cross product), so |n| = area, along the triangle's normal.       [m^2]
inline Vec3 vector_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    return 0.5 * (b - a).cross(c - a);
}

/// Signed volume of the tetrahedron of a, b, c and the origin, a·(b × c) / 6: its sum over a
/// closed surface's triangles is the enclosed volume, positive when normals point outward. [m^3]
inline double signed_volume(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c)) / 6.0;
}

}  // namespace corpuscle
