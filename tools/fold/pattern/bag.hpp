// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/pattern/plan.hpp"

namespace corpuscle::fold {

struct BagPart {
    int id;  ///< its number in the deck
    std::string title;
    bool is_front;  ///< lies in the front panel
};

/// Two panels that share the nodes of their seam, and what is sewn between them.
struct Bag {
    Sheet sheet;  ///< part: row in `parts`
    std::vector<BagPart> parts;
    std::vector<Index> seam;     ///< nodes, ascending
    std::vector<Index> module;   ///< of the hole's cover and ring, or about the inflator; ascending
    std::vector<Index> clamped;  ///< nodes, ascending
    bool has_vents = false;
    std::vector<std::string> remarks;  ///< where the mesh is not as the recipe has it
};

/// Cuts and sews: the front lies above (+z) the back, half the gap on each side of z = 0, more
/// where a tether lies between them, closing towards the seam. Seen from the front all cells run
/// counter-clockwise, as imprint() wants them.
/// @param is_alike  as make_plan() has it
/// @throws InputError as make_plan(), or if tethers overlap
[[nodiscard]] Bag make_bag(const Recipe& recipe, const PlanLines& lines, bool is_alike = false);

/// Turns the front's cells: all normals then point inward.
void turn_front(Bag& bag);

}  // namespace corpuscle::fold
