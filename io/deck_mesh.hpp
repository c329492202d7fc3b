// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// Nodes and shells of a keyword deck that need not be a whole scene.
struct DeckMesh {
    Points x;                                  ///< N × 3
    std::vector<int> node_id;                  ///< N
    std::vector<std::array<Index, 4>> shells;  ///< E × 4 node rows; a triangle repeats its 3rd
    std::vector<int> shell_id, part_id;        ///< E
    int last_node_set = 0;                     ///< greatest id of *SET_NODE; 0: there is none
    int last_part_set = 0;                     ///< likewise of *SET_PART
};

/// Reads *NODE and *ELEMENT_SHELL of a deck and its includes, as `corpuscle mesh` and preprocessors
/// write them, and what ids sets have; all other keywords are passed over.
/// @throws InputError with every fault: file, line, keyword, card, field
[[nodiscard]] DeckMesh read_deck_mesh(const std::filesystem::path& file);

}  // namespace corpuscle::io
