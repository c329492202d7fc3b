// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "fabric/lanes.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

/// A bilinear quad as x = mean + a·ξ + b·η + q·ξη, ξ and η from -1 to 1, corners anticlockwise from
/// (-1, -1); or what does work on a, b, q.
template <class Real>
struct QuadModes {
    Vector<Real> a, b, q;
};

template <class Real>
QuadModes<Real> quad_modes(const std::array<Vector<Real>, 4>& x) {
    const Vector<Real> down = x[1] - x[0], up = x[2] - x[3], left = x[3] - x[0];
    const Real quarter = Real{} + 0.25;
    return {quarter * (down + up), quarter * (left + (x[2] - x[1])), quarter * (up - down)};
}

/// f_a = -(ξ_a·A + η_a·B + ξ_a·η_a·Q)/4 for dW = A·da + B·db + Q·dq.
template <class Real>
std::array<Vector<Real>, 4> corner_forces(const QuadModes<Real>& w) {
    const Real quarter = Real{} + 0.25;
    const Vector<Real> sum = quarter * (w.a + w.b), difference = quarter * (w.a - w.b);
    const Vector<Real> q = quarter * w.q;
    return {sum - q, Vector<Real>{} - difference + q, Vector<Real>{} - sum - q, difference + q};
}

/// The same modes of a reference shape in its plane.                                       [m]
struct PlaneModes {
    Eigen::Vector2d a, b, q;
};
inline PlaneModes plane_modes(const ReferenceShape& r) {
    const auto& x = r.x;
    return {0.25 * (x[1] - x[0] + x[2] - x[3]), 0.25 * (x[3] - x[0] + x[2] - x[1]),
            0.25 * (x[0] - x[1] + x[2] - x[3])};
}

}  // namespace corpuscle::fabric
