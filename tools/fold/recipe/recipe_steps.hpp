// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/recipe/recipe.hpp"
#include "tools/fold/recipe/toml_reader.hpp"

namespace corpuscle::fold {

/// One table [[fold]], the number-th of the recipe, as the accordions that make it.
[[nodiscard]] Step read_step(const toml::table& table, int number, RecipeFaults& faults);

}  // namespace corpuscle::fold
