// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/cards/uniform_card.hpp"
#include "io/card.hpp"
#include "io/draft.hpp"

/// What keywords of bags of uniform pressure have in common.
namespace corpuscle::io::keywords {

/// The card of _ID, and the one that all control volumes begin with.
gas::UniformBagCard control_volume(Cards& cards, const Draft& draft, const char* keyword);

/// Vent (23) or leak (p23): a coefficient over time and an area over absolute pressure; below 0 the
/// area is minus the id of a part.
gas::ExitCard exit_card(Card& c, const Draft& draft, const char* C, const char* C_curve,
                        const char* A, const char* A_curve);

/// Fabric that leaks does so by its FVOPT, or by the bag's OPT where it is blank, instead of CP23
/// and AP23, which are the second of the bag's exits.
void fabric_leaks(Cards& cards, const Draft& draft, int option, gas::UniformBagCard& bag);

/// Adds the bag, whose number must be its own.
void keep_bag(Cards& cards, Draft& draft, gas::UniformBagCard bag);

}  // namespace corpuscle::io::keywords
