// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: every deck of models/ is read without a fault, and all that it is warned of is how CA is
// taken.

#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "io/deck.hpp"
#include "tests/places.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// A deck has a title; a mesh or what decks share has none.
bool is_deck(const fs::path& file) {
    if (file.extension() != ".k") return false;
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str().find("\n*TITLE") != std::string::npos;
}

}  // namespace

TEST_CASE("every deck of the models is read without a fault", "[models]") {
    std::size_t decks = 0;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(CORPUSCLE_MODELS)) {
        if (!is_deck(entry.path())) continue;
        INFO(entry.path().string());
        ++decks;
        Model model;
        REQUIRE_NOTHROW(model = io::read_deck(entry.path()));
        for (const std::string& warning : model.warnings) {
            INFO(warning);
            CHECK(warning.find(": read in degrees") != std::string::npos);
        }
        CHECK(!model.title.empty());
        CHECK((fs::exists(entry.path().parent_path() / "README.md") ||
               fs::exists(entry.path().parent_path() / "case.toml") ||
               fs::exists(entry.path().parent_path().parent_path() / "README.md")));
    }
    CHECK(decks >= 14);
}
