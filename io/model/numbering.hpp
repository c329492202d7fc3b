// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/deck_places.hpp"
#include "io/model/draft.hpp"

namespace corpuscle::io {

/// Bags, contacts and walls of which the deck has no number (0) get the place among their kind in
/// the deck, from 1, or the next number that no other one has. `places` learns where bags and
/// contacts are. After the keywords that make them.
void number_things(Draft& draft, DeckPlaces& places);

}  // namespace corpuscle::io
