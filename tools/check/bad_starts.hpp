// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace corpuscle {
class Simulation;
}

namespace corpuscle::tools {

/// Shells that cross at the start, as contact has found it: a warning for each two parts, with how
/// many pairs there are, how deep the deepest is (tools/check/crossing_depth.hpp) and where.
[[nodiscard]] std::vector<std::string> crossings_at_start(const Simulation& simulation);

}  // namespace corpuscle::tools
