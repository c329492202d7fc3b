// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::tools {

/// What a starting deck is written from.
struct NewDeck {
    std::string title;
    std::string mesh;              ///< name of the included file
    std::set<int> parts;           ///< numbers of the bag's parts
    std::set<int> numbered_parts;  ///< of those, what *PART of the mesh asks for as section and
                                   ///< material; the others get a *PART here
    bool has_part_set = false;     ///< the mesh has the part set of the whole bag
    int whole = 1;                 ///< part set of the whole bag
    int closing = 4;               ///< likewise of what closes it, where there are tethers
    bool has_vents = false;        ///< and part set 2, its vents
    int tethers = 0;               ///< part that lies inside, open to both sides; 0: none
    bool has_module = false;       ///< and node set 1, what holds it
    bool has_clamps = false;       ///< node set 3 is clamped
    std::vector<int> held;         ///< nodes that this deck holds
    int held_set = 4;              ///< their node set
    int free_node = 1;             ///< a number that no node has, nor one above it
    int free_shell = 1;            ///< likewise of shells
    Vec3 inflator = Vec3::Zero();  ///< where gas comes in
    double area = 0.0;             ///< of the cloth                                [mm^2] or [m^2]
    double volume = 0.0;           ///< at the start
    std::size_t facets = 0;
    double top = 0.0;   ///< greatest z
    bool is_mm = true;  ///< kg-mm-ms, else SI
    int head = 0;       ///< part number of a headform that flies down onto the bag; 0: none
};

/// A commented deck: gas, inflator, vents, cloth, contact, outputs. Numbers that must be thought
/// about stand in *PARAMETER, with THINK beside them. The gas is what brings the bag, blown up as
/// two discs of its area would be, to 40 kPa over the atmosphere if nothing leaves.
std::string new_deck(const NewDeck& bag);

/// A study of that deck, with a headform: its speed, and what it feels.
std::string new_study(const NewDeck& bag, const std::string& deck);

}  // namespace corpuscle::tools
