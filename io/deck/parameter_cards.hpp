// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "io/deck/card.hpp"

namespace corpuscle::io {

/// *PARAMETER and *PARAMETER_EXPRESSION, with _LOCAL and _NOECHO; *PARAMETER_DUPLICATION.
[[nodiscard]] bool is_parameter_keyword(std::string_view keyword);

/// Defines what the block says. The first definition of a name stays, with a warning, a fault or
/// nothing said of another as DFLAG 1, 3 or 5 wants it; -D goes before all.
void read_parameters(const Block& block, Parameters& parameters, Faults& faults);

}  // namespace corpuscle::io
