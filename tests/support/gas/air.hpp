// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/constants.hpp"

/// Air as in models/: Cp = 28 J/(mol K), gamma = 1.422. SI units.
namespace corpuscle::test::air {

constexpr double MOLAR_MASS = 0.028;  ///< [kg/mol]
constexpr double MOLAR_CP = 28.0;     ///< [J/(mol K)]
constexpr double GAMMA = MOLAR_CP / (MOLAR_CP - GAS_CONSTANT);
constexpr double P_ATM = 101325.0;

inline double density(double p, double T) {
    return p * MOLAR_MASS / (GAS_CONSTANT * T);
}
/// u, a mass                                                                            [J/kg]
inline double energy(double T) {
    return (MOLAR_CP - GAS_CONSTANT) / MOLAR_MASS * T;
}

}  // namespace corpuscle::test::air
