// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tools/verify/verdict.hpp"

namespace corpuscle::verify {

/// For the terminal, a line a quantity; red and green where `has_colour`.
[[nodiscard]] std::string table_text(const std::vector<Row>& rows, bool has_colour);

/// A chapter of the manual, in Markdown: a table for each family.
/// @param settings  the first paragraph: what was run
[[nodiscard]] std::string table_markdown(const std::vector<Row>& rows, const std::string& settings);

/// Families in the order of their first case.
[[nodiscard]] std::vector<std::string> families(const std::vector<Row>& rows);

/// "12 of 14 quantities hold, 2 do not: sod/density, sod/pressure"
[[nodiscard]] std::string count_text(const std::vector<Row>& rows);

/// CPU time and work of the finest level, e.g. "8.1 s, 32.4 M particle-steps".
[[nodiscard]] std::string cost_text(const Point& point);

/// CPU time of all runs of all cases.                                                       [s]
[[nodiscard]] double total_cpu(const std::vector<Row>& rows);

}  // namespace corpuscle::verify
