// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/bag.hpp"

namespace corpuscle::fold {

/// Cuts, sews and folds what the recipe says. The mesh is made for its folds: they are first tried
/// on a draft, to learn how thick the pack is and where the cloth bends; the final mesh has lines
/// there. Whether cells cross is for inspect() to say.
/// @throws InputError if a fold cannot be done
[[nodiscard]] Bag fold(const Recipe& recipe);

}  // namespace corpuscle::fold
