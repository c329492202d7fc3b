// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: `corpuscle check` names the pairs of shells that cross or are too close at the start, and
// says whether particles are too few.

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>

#include "tests/places.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;

namespace {

/// Shell 1, across shell 2 or below it; shell 3 lies 0.1 mm over the other end of shell 1.
std::string deck(double height_of_2) {
    const std::string z = std::to_string(height_of_2);
    return "*KEYWORD\n*CONTROL_TERMINATION\n1e-3\n*NODE\n"
           "1,0,0,0\n2,0.1,0,0\n3,0.1,0.1,0\n4,0,0.1,0\n"
           "5,0.02,0.05," +
           z + "\n6,0.04,0.05," + z +
           "\n7,0.03,0.05,0.02\n"
           "8,0.06,0.02,1e-4\n9,0.08,0.02,1e-4\n10,0.07,0.04,1e-4\n"
           "*ELEMENT_SHELL\n1,1,1,2,3,4\n2,1,5,6,7,7\n3,1,8,9,10,10\n"
           "*PART\nfabric\n1,1,1\n*SECTION_SHELL\n1,9\n3e-4,3e-4,3e-4,3e-4\n"
           "*MAT_ELASTIC\n1,750,3e8,0.3\n"
           "*CONTACT_AIRBAG_SINGLE_SURFACE\n0,0,5\n\n\n*END\n";
}

std::string check(const std::filesystem::path& file, const std::string& options = "") {
    const std::string command =
        CORPUSCLE_PROGRAM " check '" + file.string() + "' " + options + " 2>&1";
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> part;
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
    CHECK(pclose(pipe) == 0);
    return text;
}

}  // namespace

TEST_CASE("check names the shells that cross and those that are too close at the start",
          "[contact]") {
    using Catch::Contains;
    const test::DeckFolder folder;
    const std::string crossing = check(folder.write("crossing.k", deck(-0.02)));
    CHECK_THAT(crossing, Contains("1 pairs of shells have crossed since the start: 1-2"));
    // the tip of shell 2 stands 20 mm through shell 1, and half its thickness
    CHECK_THAT(crossing,
               Contains("WARNING: part 1 \"fabric\" crosses itself at the start: 1 pairs"));
    CHECK_THAT(crossing, Contains("up to 0.02015 deep (shells 1 and 2"));
    CHECK_THAT(crossing, Contains("nearer than the contact thickness: 1-3"));
    const std::string apart = check(folder.write("apart.k", deck(0.01)));
    CHECK_THAT(apart, Contains("contact at the start:"));
    CHECK_THAT(apart, !Contains("crossed"));
}

TEST_CASE("check says whether a bag has particles enough, and how many would be", "[contact]") {
    using Catch::Contains;
    const auto deck =
        std::filesystem::path(CORPUSCLE_MODELS) / "driver_bag_folded" / "driver_bag_folded.k";
    CHECK_THAT(check(deck, "-D NP=10000"), Contains("too few") && Contains("NP = "));
    CHECK_THAT(check(deck, "-D NP=100000"), Contains("enough") && !Contains("too few"));
}

TEST_CASE("check says what a person can judge, and what cannot be", "[check]") {
    using Catch::Contains;
    const test::DeckFolder folder;
    const auto decks = std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "tests" / "decks";
    const std::string sane = check(decks / "wang_nefske_inflator_card.k");
    CHECK_THAT(sane, Contains("cloth: 14.4 g on 0.06 m^2"));
    CHECK_THAT(sane, Contains("airbag 7: 1 l now"));
    CHECK_THAT(sane, Contains("gas: 0.2 g") && Contains("500 to 500 K"));
    CHECK_THAT(sane, Contains("gauge in that volume"));
    // the same numbers, said to be kg-mm-ms
    const std::string absurd = check(decks / "wang_nefske_inflator_card.k", "-D UNITS=kg-mm-ms");
    CHECK_THAT(absurd, Contains("material 1: its density is 8e+11 kg/m^3") &&
                           Contains("1e-09 times that would do"));
    CHECK_THAT(absurd, Contains("material 1: its modulus is 3e+17 Pa"));
}

TEST_CASE("check answers scripts in JSON, refused decks too", "[check]") {
    using Catch::Contains;
    const auto decks = std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "tests" / "decks";
    const std::string mended = check(decks / "closing_rim_part.k", "--json");
    CHECK_THAT(mended,
               Contains("\"accepted\": true") && Contains("\"mended\": [") && Contains("joins it"));
    const std::string command = CORPUSCLE_PROGRAM " check '" +
                                (decks / "closing_rim_part.k").string() + "' -D CLOSE=no --json";
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> part;
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
    CHECK(WEXITSTATUS(pclose(pipe)) == 2);
    CHECK_THAT(text, Contains("\"accepted\": false") && Contains("\"line\": 11") &&
                         Contains("is not closed: a hole of 8 edges"));
}
