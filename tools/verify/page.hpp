// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/verify/verdict.hpp"

namespace corpuscle::verify {

/// One HTML file that asks nothing of the net: verdicts, a table and a plot for each family, and
/// how to read them.
/// @param settings  what was run: program, mode, machine
[[nodiscard]] std::string page(const std::vector<Row>& rows, const std::string& settings);

}  // namespace corpuscle::verify
