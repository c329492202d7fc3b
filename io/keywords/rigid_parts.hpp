// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/card.hpp"
#include "io/draft.hpp"

namespace corpuscle::io::keywords {

/// Is its material *MAT_RIGID?
bool is_rigid(const Draft& draft, Index part);

/// The cards of *PART_INERTIA behind that of the part.
void part_inertia(Cards& cards, Draft& draft, Index part);

}  // namespace corpuscle::io::keywords
