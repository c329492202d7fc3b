// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/bag.hpp"

namespace corpuscle::fold {

/// The bag whose two panels a deck holds, sewn and laid as make_bag() lays its own: cells and parts
/// are the deck's, its x and y the flat pattern. Rims that share nodes, or whose nodes lie on each
/// other, are the seam; a rim without any partner is an open hole.
/// @throws InputError naming what is not flat, belongs to no panel, or does not fit together
[[nodiscard]] Bag make_deck_bag(const Recipe& recipe);

}  // namespace corpuscle::fold
