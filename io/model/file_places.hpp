// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/keyword_reader.hpp"
#include "io/model/draft.hpp"

namespace corpuscle::io {

/// Works out where the files of *INCLUDE_TRANSFORM lie, moves their nodes there, and notes what was
/// done. All *NODE and *DEFINE_TRANSFORMATION of the deck are read.
void place_files(DeckText& text, const Parameters& parameters, Faults& faults, Draft& draft);

}  // namespace corpuscle::io
