// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "io/deck/keyword_reader.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

/// A keyword of the deck, and its reader.
struct Task {
    const Block* block = nullptr;
    Match match;
};

/// What is to be read, each after what it refers to, with a fault or a note for what is not.
std::vector<Task> sort_out(const DeckText& text, const Parameters& parameters, Faults& faults,
                           Draft& draft);

}  // namespace corpuscle::io::keywords
