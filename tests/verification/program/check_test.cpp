// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: `corpuscle check` names the pairs of shells that cross or are too close at the start, and
// says whether particles are too few and cloth resists compression.

#include <catch2/catch.hpp>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>

#include "io/results/hdf5.hpp"
#include "tests/places.hpp"
#include "tests/support/shell.hpp"
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
               Contains("warning: part 1 \"fabric\" crosses itself at the start: 1 pairs"));
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

TEST_CASE("check names folded cloth that resists compression", "[check]") {
    using Catch::Contains;
    const auto folded = std::filesystem::path(CORPUSCLE_MODELS) / "driver_bag_folded";
    const auto text = [](const std::filesystem::path& file) {
        std::ifstream in(file);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    std::string module = text(folded / "module.k"),
                deck = text(folded / "driver_bag_folded_coarse.k");
    const std::string without = "         1       0.0       0.0       0.0      0.05\n",
                      lined = "         1      0.05       0.3       0.1      0.05\n",
                      mesh = "\nmesh_coarse.k";
    REQUIRE(module.find(without) != std::string::npos);
    module.replace(module.find(without), without.size(), lined);
    deck.replace(deck.find(mesh), mesh.size(), "\n" + (folded / mesh.substr(1)).string());
    const test::DeckFolder folder;
    const auto said = Contains("material 1 is folded to 84.1 %");
    folder.write("module.k", module);
    CHECK_THAT(check(folder.write("lined.k", deck)), said);
    CHECK_THAT(check(folded / "driver_bag_folded_coarse.k"), !said);
    // a cube of a quarter more length, shell by shell: 0.8 squared of its area is left
    const auto decks = std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "tests" / "decks";
    const std::string cube = text(decks / "cube.inc"), heading = "*ELEMENT_SHELL\n";
    const auto shells = cube.find(heading) + heading.size();
    const std::string longer = "*INCLUDE\n" + (decks / "wang_nefske_inflator_card.k").string() +
                               "\n*AIRBAG_SHELL_REFERENCE_GEOMETRY_ID\n1,1.25,1.25,1.25\n" +
                               cube.substr(shells, cube.rfind("*END") - shells);
    CHECK_THAT(check(folder.write("longer.k", "*KEYWORD\n" + longer + "*END\n")),
               Contains("material 1 is folded to 64 %"));
    CHECK_THAT(check(decks / "wang_nefske_inflator_card.k"), !Contains("material 1 is folded"));
}

TEST_CASE("check knows cloth by its reference geometry", "[check]") {
    using Catch::Contains;
    const test::DeckFolder folder;
    const auto decks = std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "tests" / "decks";
    std::ifstream in(decks / "cube.inc");
    const std::string cube{std::istreambuf_iterator<char>(in), {}}, heading = "*ELEMENT_SHELL\n";
    const auto shells = cube.find(heading) + heading.size();
    const auto told = [&](const std::string& scale) {
        return check(folder.write(
            "scaled.k", "*KEYWORD\n*INCLUDE\n" + (decks / "wang_nefske_inflator_card.k").string() +
                            "\n*AIRBAG_SHELL_REFERENCE_GEOMETRY_ID\n1," + scale + "," + scale +
                            "," + scale + "\n" + cube.substr(shells, cube.rfind("*END") - shells) +
                            "*END\n"));
    };
    const std::string twice = told("2");  // 0.0774 A^1.5 of 0.24 m^2
    CHECK_THAT(twice,
               Contains("cloth: 57.6 g on 0.24 m^2") && Contains("1 l now, some 9.1 l full"));
    CHECK_THAT(twice, !Contains("of their reference geometry") && !Contains("the mesh's units"));
    CHECK_THAT(told("0.5"), Contains(" shells are stretched by more than 30 % of their reference "
                                     "geometry at the start, shell ") &&
                                Contains("by 100 %"));
    CHECK_THAT(told("1000"), Contains("has 1e+06 times the area of its shells at the start"));
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
    // two gases of 0.1 kg/s each for 2 ms, at 600 K, of 28 and 39.95 g/mol
    const std::string mixed = check(decks / "hybrid.k");
    CHECK_THAT(mixed, Contains("gas: 0.4 g, 0.01215 mol") && Contains("600 to 600 K"));
    CHECK_THAT(mixed, !Contains("expected"));
    // the same numbers, said to be kg-mm-ms
    const std::string absurd = check(decks / "wang_nefske_inflator_card.k", "-D UNITS=kg-mm-ms");
    CHECK_THAT(absurd, Contains("material 1: its density is 8e+11 kg/m^3") &&
                           Contains("1e-09 times that would do"));
    CHECK_THAT(absurd, Contains("material 1: its modulus is 3e+17 Pa"));
    CHECK_THAT(sane, !Contains("expected"));
    CHECK_THAT(
        check(decks / "wang_nefske_inflator_card.k", "-D UNITS=ton-mm-s"),
        Contains("airbag 7: Cp of its gas is 0.00100") && Contains("1e+06 times that would do"));
}

TEST_CASE("check knows a tank, whose walls are held, from a bag that fills", "[check]") {
    using Catch::Contains;
    const std::string tank =
        check(std::filesystem::path(CORPUSCLE_MODELS) / "tank_test/tank_test.k");
    CHECK_THAT(tank, Contains("l, of walls that are held") && Contains("gauge in that volume"));
    CHECK_THAT(tank, !Contains(" full") && !Contains("gauge in that volume: -"));
}

TEST_CASE("pounds and inches are spoken of in everyday units, however they are said", "[check]") {
    using Catch::Contains;
    const test::DeckFolder folder;
    // the cube of tests/decks, 10 inches wide
    const auto decks = std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "tests" / "decks";
    const auto deck = [&](const std::string& remark) {
        return folder.write("pounds.k", remark +
                                            "*KEYWORD\n*TITLE\npounds and inches\n"
                                            "*CONTROL_TERMINATION\n0.01\n*INCLUDE\n" +
                                            (decks / "cube.inc").string() +
                                            "\n*PART\na\n1,1,1\n*PART\nb\n2,1,1\n"
                                            "*SET_PART_LIST\n1\n1,2\n*SECTION_SHELL\n1,9\n"
                                            ".015,.015,.015,.015\n*MAT_ELASTIC\n1,1e-4,2e5,.3\n"
                                            "*DEFINE_CURVE\n10\n0,.01\n1,.01\n"
                                            "*AIRBAG_SIMPLE_AIRBAG_MODEL\n1,1\n"
                                            "1.11e6,1.556e6,900,10,.6,0,14.7,1.1e-7\n*END\n");
    };
    for (const auto& [remark, option] :
         {std::pair("$ corpuscle: UNITS = lbf-in-s\n", ""), std::pair("", "-D UNITS=lbf-in-s")}) {
        const std::string told = check(deck(remark), option);
        CHECK_THAT(told, Contains("units: lbf-in-s-K"));
        // 0.06 square inches of .015 in; density 1e-4 lbf s2/in^4 = 1069 kg/m^3
        CHECK_THAT(told, Contains("cloth: 0.01576 g on 3.871e-05 m^2"));
        CHECK_THAT(told, Contains("airbag 1: 1.639e-05 l now"));
        CHECK_THAT(told, !Contains("expected"));
    }
    CHECK_THAT(check(deck("")), Contains("units are not known") && Contains("lbf-in-s-K"));
}

TEST_CASE("check tells how many steps a run takes, whatever its first one is", "[check]") {
    const auto models = std::filesystem::path(CORPUSCLE_MODELS);
    const test::DeckFolder folder;
    for (const char* model : {"fast_piston/fast_piston.k", "verification/vent_by_chamber/case.k"}) {
        CAPTURE(model);
        const std::string told = check(models / model, "-j 1");
        const double steps = std::stod(told.substr(told.rfind("), ") + 3));
        const std::string out = (folder.write("here", "").parent_path() / "out").string();
        const auto [status, text] =
            test::shell(CORPUSCLE_PROGRAM " run '" + (models / model).string() + "' -o '" + out +
                        "' -j 2 2>&1");
        REQUIRE(status == 0);
        const double made = std::stod(text.substr(text.find(" after ") + 7));
        CHECK(steps > 0.5 * made);
        CHECK(steps < 2.0 * made);
    }
    // DTINIT is of the first step alone
    const std::string plain = deck(0.01), with_start = "*KEYWORD\n*CONTROL_TIMESTEP\n1e-12\n" +
                                                       plain.substr(plain.find('\n') + 1);
    const std::string told = check(folder.write("start.k", with_start)),
                      other = check(folder.write("plain.k", plain));
    CHECK_THAT(told, Catch::Contains("first step 1e-12, by DTINIT"));
    CHECK(std::stod(told.substr(told.rfind("), ") + 3)) ==
          std::stod(other.substr(other.rfind("), ") + 3)));
}

TEST_CASE("every mending is told by check, by the summary and in results.h5", "[check]") {
    using Catch::Contains;
    const test::DeckFolder folder;
    const auto decks = std::filesystem::path(CORPUSCLE_MODELS).parent_path() / "tests" / "decks";
    const std::string out = (folder.write("here", "").parent_path() / "out").string();
    for (const auto& [deck, what] : {std::pair("closing_rim_part.k", "joins it: its 4 shells"),
                                     std::pair("closing_hanging.k", "16 hanging nodes tied"),
                                     std::pair("closing_hole.k", "closed by a lid without mass")}) {
        CAPTURE(deck);
        CHECK_THAT(check(decks / deck), Contains("mended: ") && Contains(what));
        CHECK_THAT(check(decks / deck, "--json"), Contains("\"mended\": [") && Contains(what));
        const auto [status, told] = test::shell(
            CORPUSCLE_PROGRAM " run '" + (decks / deck).string() + "' -o '" + out + "' 2>&1");
        REQUIRE(status == 0);
        CHECK_THAT(told, Contains("mended: ") && Contains(what));
        CHECK_THAT(io::Hdf5Reader(out + "/results.h5").text("/", "mendings"), Contains(what));
    }
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
