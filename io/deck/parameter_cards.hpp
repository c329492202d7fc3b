// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "io/deck/card.hpp"

namespace corpuscle::io {

/// *PARAMETER and *PARAMETER_EXPRESSION, with _LOCAL, _MUTABLE and _NOECHO;
/// *PARAMETER_DUPLICATION.
[[nodiscard]] bool is_parameter_keyword(std::string_view keyword);

/// Defines what the block says. Of a name that has a definition the first one stays (DFLAG 1 and 5),
/// or each counts for the cards behind it (2 and 4, _MUTABLE), or it is a fault (3); -D goes before
/// all.
void read_parameters(const Block& block, Parameters& parameters, Faults& faults);

}  // namespace corpuscle::io
