// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

#include "fabric/materials/plane_stress.hpp"
#include "fabric/reference_shape.hpp"

namespace corpuscle::fabric {

/// Stiffness of an element at rest in its plane, from its own kernel: the force of unit strain
/// rates, one corner and direction at a time. Order: corner 0 along warp, along weft, corner 1 ...
/// [N/m]
template <class Element>
Eigen::MatrixXd rest_stiffness(const Element& element, const ReferenceShape& r,
                               const PlaneModuli& moduli) {
    typename Element::Corners x;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double height = r.warp * (i % 2 == 0 ? 1.0 : -1.0);
        x[i] = {r.x[i].x(), r.x[i].y(), height};
    }
    const auto rest = element.motion(x);
    const int size = 2 * Element::CORNERS;
    Eigen::MatrixXd k(size, size);
    for (int column = 0; column < size; ++column) {
        typename Element::Corners u{};
        (column % 2 == 0 ? u[static_cast<std::size_t>(column / 2)].x
                         : u[static_cast<std::size_t>(column / 2)].y) = 1.0;
        const auto load = element.viscous(moduli, rest, element.motion(u));
        const auto f = element.spread(rest, load, 1.0);
        for (int c = 0; c < Element::CORNERS; ++c) {
            k(2 * c, column) = -f[static_cast<std::size_t>(c)].x;
            k(2 * c + 1, column) = -f[static_cast<std::size_t>(c)].y;
        }
    }
    return k;
}

/// Highest frequency squared of the element alone with its mass shared equally by its corners. No
/// mesh vibrates faster than its fastest element [Irons 1970]. For a triangle it is (3/(rho·h))
/// λmax(D^½ B Bᵀ D^½).                                                            [1/s^2]
template <class Element>
double highest_frequency_squared(const Element& element, const ReferenceShape& r,
                                 const PlaneModuli& moduli, double mass) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(rest_stiffness(element, r, moduli),
                                                               Eigen::EigenvaluesOnly);
    return modes.eigenvalues().maxCoeff() * Element::CORNERS / mass;
}

/// Central differences with damping of the velocity half a step back keep every mode below
/// 1 - β·ω²·dt/2 - ω²·dt²/4 > 0, so with ζ = β·ω/2
///
///     dt = (2/ω)·(sqrt(1 + ζ²) - ζ)
///
/// @returns  (2/dt)² [1/s^2]
inline double step_rate(double frequency_squared, double damping_time) {
    const double share = 0.5 * damping_time * std::sqrt(frequency_squared);
    const double factor = std::sqrt(1.0 + share * share) + share;  // 1/(sqrt(1 + ζ²) - ζ)
    return frequency_squared * factor * factor;
}

/// The mass, as a multiple of the element's own, for which dt is just stable.                  [-]
inline double mass_factor(double frequency_squared, double damping_time, double dt) {
    return 0.5 * frequency_squared * dt * (damping_time + 0.5 * dt);
}

}  // namespace corpuscle::fabric
