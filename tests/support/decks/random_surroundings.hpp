// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tests/support/decks/random_plan.hpp"

namespace corpuscle::support {

/// Cards of what stands in the way of cloth that moves, drawn apart: a plane above the bag or
/// beside it, or a rigid body that flies against its top; some of the cloth's weight, and its speed
/// where nothing holds it. Says so in `words`.
[[nodiscard]] std::string surroundings(const Plan& plan, unsigned seed, std::string& words);

}  // namespace corpuscle::support
