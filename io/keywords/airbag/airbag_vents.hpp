// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/cards/bag.hpp"
#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

/// The rows of *AIRBAG_PARTICLE that say where gas and heat leave.
namespace corpuscle::io::keywords {

/// One NVENT row; appends one vent, or for STYPE3 = 1 one for each part of the set.
void vent(Cards& cards, const Draft& draft, gas::BagCard& bag);

/// One NPDATA row.
void part_data(Cards& cards, const Draft& draft, gas::BagCard& bag);

/// FRIC or PFRIC: a factor, or minus the id of a curve over the part's pressure. False: none.
bool friction(Card& c, const char* name, const Draft& draft, gas::FrictionCard& rough);

/// BLOCK of card 1.
void block(Card& c, gas::BagCard& bag);

/// What its fabrics' leak fields ask for; faults where nothing acts on it.
void check_leaks(Cards& cards, const Draft& draft, const gas::BagCard& bag);

}  // namespace corpuscle::io::keywords
