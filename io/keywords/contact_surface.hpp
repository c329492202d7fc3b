// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include "io/card.hpp"
#include "io/draft.hpp"

namespace corpuscle::io::keywords {

/// Names of the fields of one side of a contact.
struct SideFields {
    std::string_view surface, type;
};
inline constexpr SideFields SIDE_A{"SURFA", "SURFATYP"}, SIDE_B{"SURFB", "SURFBTYP"};

/// Part rows of a side: type 2 part set, 3 part, 5 or no surface at all: every part, 6 all but a
/// part set; 0 segment set, 1 shell set and, if `may_be_nodes`, 4 node set, where they are those of
/// whole parts.
std::vector<Index> contact_side(Card& c, const Draft& draft, const SideFields& side,
                                bool may_be_nodes);

}  // namespace corpuscle::io::keywords
