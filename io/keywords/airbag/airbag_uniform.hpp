// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/cards/uniform_card.hpp"
#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

/// What keywords of bags of uniform pressure have in common.
namespace corpuscle::io::keywords {

/// The card of _ID, and the one that all control volumes begin with.
gas::UniformBagCard control_volume(Cards& cards, const Draft& draft, const char* keyword);

/// Of the shells that close the bag.
std::vector<Index> parts_of(const Draft& draft, const gas::UniformBagCard& bag);

/// Heat capacities per mass; 0 for CV: they come with the molar ones of a later card.
void heat_capacities(Card& c, gas::UniformBagCard& bag);

/// cp = (A + B T) / MW and cv = cp - GASC / MW, with T = TEXT throughout.
void molar_heat_capacities(Card& c, gas::UniformBagCard& bag);

/// Vent (23) or leak (p23): a coefficient over time and an area over absolute pressure; below 0 the
/// area is minus the id of a part.
gas::ExitCard exit_card(Card& c, const Draft& draft, const char* C, const char* C_curve,
                        const char* A, const char* A_curve);

/// A value, or below 0 minus the id of a curve.
gas::CurveOr value_or_curve(Card& c, const char* name, const Registry& curves);

/// Cards of _JETTING, `most` of them: the gas is uniform here, so they push nothing.
void skip_jets(Cards& cards, int most);

/// The shells of a part; a fault of the field when there are none.
/// @param expected  what the field may hold
std::vector<std::array<Index, 4>> facets_of_part(Card& c, const Draft& draft, const char* field,
                                                 double id, const char* expected);

/// Fabric that leaks does so by its FVOPT, or by the bag's OPT where it is blank, instead of CP23
/// and AP23, which are the second of the bag's exits.
void fabric_leaks(Cards& cards, const Draft& draft, int option, gas::UniformBagCard& bag);

/// Adds the bag, whose number must be its own.
void keep_bag(Cards& cards, Draft& draft, gas::UniformBagCard bag);

}  // namespace corpuscle::io::keywords
