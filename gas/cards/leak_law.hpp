// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle::gas {

/// What FAC of fabric that leaks is, by FVOPT: with gauge pressure dp and density rho of the gas
/// inside, gas seeps through a share FLC of the area at the speed
enum class LeakLaw {
    VELOCITY,  ///< FVOPT 7, 8:  FAC                                            FAC [m/s]
    ORIFICE,   ///< FVOPT 1, 2:  FAC m' / rho, m' of an orifice, Wang-Nefske    FAC [-]
    HEAD,      ///< FVOPT 3, 4:  FAC sqrt(2 dp / rho)                           FAC [-]
    POROUS     ///< FVOPT 5, 6:  FAC dp / rho, Darcy                            FAC [s/m]
};

}  // namespace corpuscle::gas
