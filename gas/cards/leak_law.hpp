// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle::gas {

/// What FAC of fabric that leaks is, by FVOPT (leak_speed.hpp).
enum class LeakLaw {
    VELOCITY,  ///< 7, 8
    ORIFICE,   ///< 1, 2
    HEAD,      ///< 3, 4
    POROUS     ///< 5, 6
};

}  // namespace corpuscle::gas
