// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle::io {

/// Names that -D may give a value, upper case.
struct DeckParameters {
    std::vector<std::string> of_deck,  ///< of *PARAMETER, in alphabetical order
        of_program;                    ///< that every deck has: COLLISION, UNITS, ...
    bool is_whole = false;             ///< the deck was read without a fault, so these are all

    /// Of either kind, in any case.
    [[nodiscard]] bool has(const std::string& name) const;
};

/// Those of a deck and all that it includes.
[[nodiscard]] DeckParameters read_deck_parameters(const std::filesystem::path& deck);

}  // namespace corpuscle::io
