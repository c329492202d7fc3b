// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

#include <array>
#include <cmath>

#include "fabric/lanes.hpp"
#include "fabric/materials/plane_stress.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

/// Two directions for each of at most four corners, on the stack.
using CornerMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 8, 8>;

/// Stiffness of an element at rest in its plane, from its own kernel: the force of unit strain
/// rates, one corner and direction at a time. Order: corner 0 along warp, along weft, corner 1 ...
/// [N/m]
template <class Element>
CornerMatrix rest_stiffness(const Element& element, const ReferenceShape& r,
                            const PlaneModuli& moduli) {
    typename Element::Corners x;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double height = r.warp * (i % 2 == 0 ? 1.0 : -1.0);
        x[i] = {r.x[i].x(), r.x[i].y(), height};
    }
    const auto rest = element.motion(x);
    const int size = 2 * Element::CORNERS;
    CornerMatrix k(size, size);
    for (int column = 0; column < size; ++column) {
        typename Element::Corners u{};
        Vector<double>& at = u[static_cast<std::size_t>(column / 2)];
        (column % 2 == 0 ? at.x : at.y) = 1.0;
        const auto load = element.viscous(moduli, rest, element.motion(u));
        const auto f = element.spread(rest, load, 1.0);
        for (int c = 0; c < Element::CORNERS; ++c) {
            k(2 * c, column) = -f[static_cast<std::size_t>(c)].x;
            k(2 * c + 1, column) = -f[static_cast<std::size_t>(c)].y;
        }
    }
    return k;
}

/// Highest frequency squared of an element whose corners weigh mass[0], mass[1], ... For equal
/// corners of a triangle it is (3/(rho·h)) λmax(D^½ B Bᵀ D^½). [1/s^2]
double highest_frequency_squared(const CornerMatrix& stiffness, const double* mass);

/// Central differences with damping of the velocity half a step back keep every mode below
/// 1 - β·ω²·dt/2 - ω²·dt²/4 > 0, so with ζ = β·ω/2
///
///     dt = (2/ω)·(sqrt(1 + ζ²) - ζ)
///
/// @returns  (2/dt)² [1/s^2]
template <class Real>
Real step_rate(const Real& frequency_squared, const Real& damping_time) {
    const Real share = 0.5 * damping_time * square_root(frequency_squared);
    const Real factor = square_root(1.0 + share * share) + share;  // 1/(sqrt(1 + ζ²) - ζ)
    return frequency_squared * factor * factor;
}

/// The mass that makes dt just stable, over the mass that makes dt_0 so.                        [-]
inline double mass_factor(double dt_0, double dt, double damping_time) {
    return dt * (damping_time + 0.5 * dt) / (dt_0 * (damping_time + 0.5 * dt_0));
}

}  // namespace corpuscle::fabric
