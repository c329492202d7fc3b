// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

namespace corpuscle::io::keywords {

/// Is its material *MAT_RIGID?
bool is_rigid(const Draft& draft, Index part);

/// The part that leads the merged body which this one is of; itself, if it is not merged.
Index lead_of(const Draft& draft, Index part);

/// A fault unless the part leads its body: what says how a body moves is said of its lead.
void expect_lead(Card& c, const Draft& draft, const char* field, Index part);

/// The lead of the rigid part that each node belongs to, or -1; by node row.
const std::vector<Index>& rigid_owners(Draft& draft);

/// Holds a body along axes of the card's file and about them (bits x, y, z): along those of the deck
/// where these are its axes too, else along its own.
void hold_along_axes(const FilePlace& file, unsigned moves, unsigned turns,
                     fabric::RigidCard& rigid);

/// The cards of *PART_INERTIA behind that of the part.
void part_inertia(Cards& cards, Draft& draft, Index part);

}  // namespace corpuscle::io::keywords
