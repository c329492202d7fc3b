// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "solver/model.hpp"

/// Decks, meshes, results, checkpoints and units: what a scene is read from and written to.
namespace corpuscle::io {

class DeckPlaces;
class FieldLog;

/// What the command line adds to a deck.
struct DeckOptions {
    std::vector<std::pair<std::string, std::string>> overrides;  ///< -D NAME=VALUE, one for each
    FieldLog* log = nullptr;                                     ///< learns what becomes of fields
    double until = 0.0;  ///< functions of time are known to ENDTIM and to this at least   [s]
};

/// The scene that an LS-DYNA keyword deck describes, with its includes.
///
/// Warnings (what is skipped, assumed, or does not act here) are in Model::warnings.
/// `places`, if given, learns where the deck has what later faults of the scene name.
/// @throws InputError with every fault of the deck, each with file, line, keyword, card and field.
Model read_deck(const std::filesystem::path& file, const DeckOptions& options = {},
                DeckPlaces* places = nullptr);

}  // namespace corpuscle::io
