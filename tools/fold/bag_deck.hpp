// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "tools/fold/inspect/inspect.hpp"

namespace corpuscle::fold {

/// The bag as keyword cards: *NODE (folded), *ELEMENT_SHELL, *AIRBAG_REFERENCE_GEOMETRY (flat) and
/// sets: part set 1 the bag, part set 2 the vents, node set 1 the module's cover and ring, or
/// the cloth about the inflator, node set 2 the seam, node set 3 what is clamped. *PART, *SECTION_SHELL and *MAT_ are left to the deck that includes it.
[[nodiscard]] std::string bag_deck(const Bag& bag, const Recipe& recipe, const Inspection& found);

/// Two cuts through the middle of the pack, along x and along y, as a drawing.
[[nodiscard]] std::string section_svg(const Bag& bag, const Inspection& found);

}  // namespace corpuscle::fold
