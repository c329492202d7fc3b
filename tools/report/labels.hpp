// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace corpuscle::report {

/// A history's path as a person says it: "airbag/1/mass_out_vent" is "bag 1: gone through vents",
/// "rigid_body/20/force.z" is "rigid body 20 \"head\": force, z".
/// @param titles  of parts
[[nodiscard]] std::string label_of(const std::string& path,
                                   const std::map<int, std::string>& titles);

}  // namespace corpuscle::report
