// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

namespace corpuscle {

/// Universal gas constant, CODATA 2018 (exact)                                      [J/(mol K)]
inline constexpr double GAS_CONSTANT = 8.31446261815324;

/// Default pressure of the atmosphere of *AIRBAG_PARTICLE                            [Pa]
inline constexpr double ATMOSPHERE_PRESSURE = 101325.0;
/// Default temperature of the same                                                    [K]
inline constexpr double ATMOSPHERE_TEMPERATURE = 293.0;

}  // namespace corpuscle
