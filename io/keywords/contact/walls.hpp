// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/rigid_walls/wall_card.hpp"
#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

/// What *RIGIDWALL_PLANAR and *RIGIDWALL_GEOMETRIC have in common.
namespace corpuscle::io::keywords {

/// The card of _ID: the number, 0 without one.
void wall_name(Cards& cards, contact::WallCard& wall);

/// NSID = 0: every node; without those of NSIDEX; of them those in BOXID at the start.
std::vector<Index> stopped_nodes(Card& c, const Draft& draft);

/// XT YT ZT and XH YH ZH: the tail, and the unit vector to the head.
struct Arrow {
    Vec3 tail = Vec3::Zero(), direction = Vec3::UnitZ();
};
Arrow arrow(Card& c);

/// XHEV ... LENL LENM (and LENP): a rectangle with its normal, or the brick behind it.
contact::WallShape rectangle(Cards& cards, const Arrow& normal, bool has_depth);

/// The card of _DISPLAY, if there is one: pictures only.
void skip_display(Cards& cards);

/// Adds the wall, whose number must be its own.
void add_wall(Cards& cards, Draft& draft, contact::WallCard wall);

}  // namespace corpuscle::io::keywords
