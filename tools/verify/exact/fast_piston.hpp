// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/constants.hpp"
#include "solver/base/curve.hpp"
#include "tools/verify/exact/euler_1d.hpp"

/// The course notes' "Quick adiabatic expansion" (models/fast_piston) as a 1-D tube.
namespace corpuscle::oracle::fast_piston {

inline constexpr double CP = 28.0;           ///< of air, as printed                    [J/(mol K)]
inline constexpr double MOLAR_MASS = 0.028;  ///< of air, as printed                    [kg/mol]
inline constexpr double GAMMA = CP / (CP - GAS_CONSTANT);
inline constexpr double TEMPERATURE = 210.9 * GAMMA;  ///< at rest: gamma times the static one [K]
inline constexpr double SIDE = 0.2;                   ///< of the box before it grows          [m]
inline constexpr double MASS = 0.010;                 ///< of the air                          [kg]
inline constexpr double START = 5.0e-3;               ///< the piston stands still until then  [s]

/// p = nRT/V before the piston moves.                                                         [Pa]
inline constexpr double PRESSURE =
    MASS / MOLAR_MASS * GAS_CONSTANT * TEMPERATURE / (SIDE * SIDE * SIDE);

/// Curve 3 of the deck.                                                                      [m/s]
inline double velocity(double t) {
    static const Curve curve{
        3, {0.0, 5.0e-3, 5.2e-3, 5.8e-3, 6.0e-3, 1.0}, {0.0, 0.0, 400.0, 400.0, 0.0, 0.0}};
    return curve(t);
}

/// The tube at START, the gas at rest; its time runs from there.
inline EulerTube tube(std::size_t cells) {
    const double density = MASS / (SIDE * SIDE * SIDE);
    return {GAMMA, SIDE, cells, [density](double) { return Gas1D{density, 0.0, PRESSURE}; }};
}

/// Pressure on the piston at `times`, ascending and not before START, on `cells` cells.       [Pa]
inline std::vector<double> piston_pressure(const std::vector<double>& times, std::size_t cells) {
    EulerTube gas = tube(cells);
    std::vector<double> pressure;
    for (double t : times) {
        gas.advance(t - START, [](double since) { return velocity(START + since); });
        pressure.push_back(gas.piston_pressure());
    }
    return pressure;
}

}  // namespace corpuscle::oracle::fast_piston
