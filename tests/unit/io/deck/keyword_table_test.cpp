// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cstdlib>
#include <sstream>

#include "deck_scene.hpp"
#include "io/keywords/keyword_table.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::filesystem::path FILE_OF_TABLE = CORPUSCLE_KEYWORD_TABLE;

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("the table of keywords is what the readers do (CORPUSCLE_WRITE_TABLE=1 writes it)",
          "[io]") {
    const DeckFolder folder;
    const std::string table = io::keyword_table(folder.write("here", "").parent_path());
    if (std::getenv("CORPUSCLE_WRITE_TABLE") != nullptr)
        std::ofstream(FILE_OF_TABLE, std::ios::binary) << table;
    CHECK(text_of(FILE_OF_TABLE) == table);
    // what a user would look up first
    CHECK(contains(table, "| `*AIRBAG_WANG_NEFSKE` |"));
    CHECK(contains(table, "IABT"));
}
