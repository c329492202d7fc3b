// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/geometry/inside.hpp"

#include <cmath>
#include <numbers>

namespace corpuscle::oracle {

double winding_number(const Vec3& point, const std::vector<std::array<Vec3, 3>>& triangles) {
    double sum = 0.0;
    for (const auto& triangle : triangles) {
        const Vec3 a = triangle[0] - point, b = triangle[1] - point, c = triangle[2] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm();
        const double volume = a.dot(b.cross(c));
        const double cosine = la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
        sum += std::atan2(volume, cosine);  // half the solid angle
    }
    return sum / (2.0 * std::numbers::pi);
}

bool is_inside(const Vec3& point, const std::vector<std::array<Vec3, 3>>& triangles, double slack) {
    const auto inside = [&](const Vec3& at) {
        return std::abs(winding_number(at, triangles)) > 0.5;
    };
    if (inside(point)) return true;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 aside = slack * Vec3::Unit(axis);
        if (inside(point + aside) || inside(point - aside)) return true;
    }
    return false;
}

}  // namespace corpuscle::oracle
