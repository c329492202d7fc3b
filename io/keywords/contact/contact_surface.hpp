// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

namespace corpuscle::io::keywords {

/// Names of the fields of one side of a contact.
struct SideFields {
    std::string_view surface, type;
};
inline constexpr SideFields SIDE_A{"SURFA", "SURFATYP"}, SIDE_B{"SURFB", "SURFBTYP"};

/// One side of a contact: parts, and of those that are not whole the shells that are meant.
struct ContactSide {
    std::vector<Index> parts;        ///< rows
    std::vector<Index> some_shells;  ///< rows
};

/// Type 2 part set, 3 part, 5 or no surface at all: every part, 6 all but a part set; 0 segment
/// set, 1 shell set and, if `may_be_nodes`, 4 node set: the shells that have only such nodes, and
/// with a warning those that have some, where a node would be left out.
ContactSide contact_side(Card& c, const Draft& draft, const SideFields& side, bool may_be_nodes);

/// Leaves the shells alone whose nodes are all in the box that the field names, if it names one.
void keep_in_box(Card& c, const Draft& draft, std::string_view field, ContactSide& side);

}  // namespace corpuscle::io::keywords
