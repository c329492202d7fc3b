// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/verify/verdict.hpp"

namespace corpuscle::verify {

/// |error| over budget against the CPU time of a run, a line for each quantity, both axes
/// logarithmic: an SVG element. Below the dashed line a budget holds.
/// Quantities whose error is 0 on all levels have no place in it; empty if none is left.
[[nodiscard]] std::string error_plot(const std::vector<Row>& rows);

}  // namespace corpuscle::verify
