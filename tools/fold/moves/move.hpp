// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <variant>

#include "tools/fold/moves/accordion.hpp"
#include "tools/fold/moves/tuck.hpp"

namespace corpuscle::fold {

/// One fold of the whole pack. Both kinds offer choose_bands, apply, distance, borders, is_turned
/// and before, and have angle, is_left and band.
using Move = std::variant<Accordion, Tuck>;

}  // namespace corpuscle::fold
