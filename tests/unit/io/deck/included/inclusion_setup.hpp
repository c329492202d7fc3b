// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/unit/io/deck/deck_scene.hpp"

/// Decks that bring in a file by *INCLUDE_TRANSFORM.
namespace corpuscle::test {

/// The cards of a file with these offsets (two lines) and this transformation.
inline std::string inclusion(const std::string& file, const std::string& offsets = "0\n0\n",
                             int transformation = 0) {
    return "*INCLUDE_TRANSFORM\n" + file + "\n" + offsets + "\n" + std::to_string(transformation) +
           "\n";
}

/// 1000 more for nodes, 2000 for elements, and so on to 8000 for what has no offset of its own.
inline const std::string EACH_OFFSET = "1000,2000,3000,4000,5000,6000,7000\n8000\n";

/// The model of a deck that includes the file by the cards.
inline Model read_included(const std::string& file, const std::string& deck) {
    const DeckFolder folder;
    folder.write("file.k", file);
    return folder.read("*KEYWORD\n" + deck + "*END\n");
}

inline std::vector<std::string> included_faults(const std::string& file, const std::string& deck) {
    const DeckFolder folder;
    folder.write("file.k", file);
    return folder.faults("*KEYWORD\n" + deck + "*END\n");
}

/// The small deck with `more` behind it, as it is and placed by the transformation's rows.
struct Placed {
    Model plain, moved;
};
inline Placed placed_small(const std::string& more, const std::string& rows) {
    return {read_small(more),
            read_included(small_deck(more),
                          inclusion("file.k", "0\n0\n", 7) + "*DEFINE_TRANSFORMATION\n7\n" + rows)};
}

}  // namespace corpuscle::test
