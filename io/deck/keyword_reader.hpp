// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/deck/card.hpp"
#include "io/deck/faults.hpp"
#include "io/deck/included/inclusion.hpp"
#include "io/deck/parameters.hpp"

namespace corpuscle::io {

/// The text of a deck as keywords in the order in which they are met: includes unfolded, comments
/// out.
struct DeckText {
    struct File {
        std::string text;
        std::vector<Line> lines;
    };
    std::deque<File> files;     ///< what the blocks' views point into; moves, never copies
    std::vector<Block> blocks;  ///< all but *KEYWORD, *INCLUDE, *PARAMETER and *END, which are done
    std::deque<Inclusion> inclusions;  ///< *INCLUDE_TRANSFORM, in the order met
    Place end;                         ///< where reading stopped, in the deck itself
    bool is_incomplete = false;  ///< some text could not be read: what it may hold is no fault
};

/// Reads a deck with its includes, and its parameters into `parameters`.
///
/// *INCLUDE names are looked for beside the including file, beside the deck, then along
/// *INCLUDE_PATH; so are those of *INCLUDE_TRANSFORM, whose offsets are known and whose places are
/// not yet.
DeckText read_keywords(const std::filesystem::path& deck, Parameters& parameters, Faults& faults);

/// Why the text of a file has no lines that can be read: its encoding, its line ends. Empty: it has.
std::string why_no_lines(std::string_view text);

/// Lines of a file: comments left out, tabs of fixed cards turned into blanks up to each 8th
/// column.
///
/// @param text  the file; rewritten when it holds tabs
std::vector<Line> split_lines(std::string& text);

}  // namespace corpuscle::io
