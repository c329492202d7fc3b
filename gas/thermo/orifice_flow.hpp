// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corpuscle::gas {

/// Mass flow through a hole, per area, from a gas at rest at p and T to where there is `p_out`:
/// isentropic up to the hole's edge, choked below the critical pressure ratio [Wang & Nefske 1988].
///
///     m'/A = p Q^(1/g) sqrt( 2 g/(g - 1) (1 - Q^((g-1)/g)) / (R T) ),  g = gamma,
///     Q = max(p_out / p, (2/(g + 1))^(g/(g - 1)))
///
/// 0 when p <= p_out. Departs from the course notes, whose R and M are in each other's place.
/// Cost: 3 pow, 1 sqrt.
/// @param R  gas constant by mass                                              [J/(kg K)]
/// @returns  mass flow per area                                              [kg/(m^2 s)]
inline double orifice_flow(double p, double p_out, double T, double gamma, double R) {
    if (!(p > p_out)) return 0.0;
    const double choked = std::pow(2.0 / (gamma + 1.0), gamma / (gamma - 1.0));
    const double Q = std::max(p_out / p, choked);
    const double fall = 1.0 - std::pow(Q, (gamma - 1.0) / gamma);
    return p * std::pow(Q, 1.0 / gamma) * std::sqrt(2.0 * gamma / (gamma - 1.0) * fall / (R * T));
}

/// Speed at which a gas at rest effuses: a quarter of the mean speed, sqrt(R T / (2 pi M)); times
/// the density it is the mass that meets a wall per area and time.                          [m/s]
[[nodiscard]] inline double effusion_speed(double T, double gas_constant, double molar_mass) {
    return std::sqrt(gas_constant * T / (2.0 * std::numbers::pi * molar_mass));
}

}  // namespace corpuscle::gas
