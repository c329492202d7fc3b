// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "gas/cards/leak_law.hpp"
#include "gas/thermo/orifice_flow.hpp"

namespace corpuscle::gas {

/// Factor on FAC that gives the speed at which gas seeps through fabric; mass flow per area is
/// density · FLC · FAC · factor:
///
///     VELOCITY  1                        FAC [m/s]    FVOPT 7, 8
///     ORIFICE   m'/A of orifice_flow / rho   FAC [-]  FVOPT 1, 2    [Wang & Nefske 1988]
///     HEAD      sqrt(2 (p - p_out) / rho)    FAC [-]  FVOPT 3, 4    [Graefe et al. 1990]
///     POROUS    (p - p_out) / rho            FAC [s/m]  FVOPT 5, 6  (Darcy)
///
/// 0 when p <= p_out, but for VELOCITY.
/// @param density  of the gas at p                                               [kg/m^3]
inline double leak_speed(LeakLaw law, double p, double p_out, double density, double gamma) {
    if (law == LeakLaw::VELOCITY) return 1.0;
    if (!(p > p_out) || !(density > 0.0)) return 0.0;
    switch (law) {
        case LeakLaw::ORIFICE:
            return orifice_flow(p, p_out, 1.0, gamma, p / density) / density;  // R T = p / density
        case LeakLaw::HEAD:
            return std::sqrt(2.0 * (p - p_out) / density);
        default:
            return (p - p_out) / density;
    }
}

}  // namespace corpuscle::gas
