// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"
#include "io/deck/deck_places.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("a lone star is a fault of its own", "[io]") {
    const DeckFolder folder;
    const auto faults = folder.faults(small_deck("*\n1,2\n* +\n*+\n"));
    REQUIRE(faults.size() == 1);
    CHECK(faults[0] ==
          "deck.k:30: *, expected the name of a keyword behind it (and 2 more like it)");
}

TEST_CASE("a line of megabytes is shown by its ends", "[io]") {
    const DeckFolder folder;
    const std::string long_one(2000000, 'x');
    for (const std::string& text :
         {"*" + long_one + "\n", "*TITLE\nt\n*NODE\n" + long_one + "\n",
          "*INCLUDE\n" + long_one + "\n", "*NODE\n7," + long_one + ",0,0\n"}) {
        const auto faults = folder.faults(small_deck(text));
        REQUIRE_FALSE(faults.empty());
        for (const std::string& fault : faults) {
            CHECK(fault.size() < 2000);
            CHECK(contains(fault, "expected") + contains(fault, "not supported") > 0);
        }
    }
}

TEST_CASE("ten faults get ten messages, each with file and line", "[io]") {
    const DeckFolder folder;
    folder.write("more.k", "*NODE\n7,0,0,0\n7,1,1,1\n*END\n");
    const auto faults = folder.faults(
        "*KEYWORD\n"
        "*NODE\n"
        "1,0,0,0\n"
        "2,1,0,0\n"
        "3,1,oops,0\n"  // 5: not a number
        "*ELEMENT_SHELL\n"
        "1,1,1,2,9,9\n"  // 7: no such node
        "2,1,1,2,2,3\n"  // 8: a node twice
        "*PART\n"
        "cloth\n"
        "1,1,5\n"  // 11: no such material
        "*SECTION_SHELL\n"
        "1,5\n"
        "-0.3\n"  // 14: thickness
        "*MAT_ELASTIC\n"
        "1,0.0,1.e8,0.3\n"  // 16: density
        "*DEFINE_CRUVE\n"   // 17: misspelt
        "1\n"
        "*CONTROL_TIMESTEP\n"
        "0.0,1.5\n"  // 20: TSSFAC
        "*INCLUDE\n"
        "more.k\n"  // more.k:3: node twice
        "*END\n");  // 23: no end time
    CAPTURE(faults);
    REQUIRE(faults.size() == 10);
    CHECK(faults[0] == "deck.k:5: *NODE card 3, field 3 (Y) = oops, expected a number");
    CHECK(faults[1] ==
          "deck.k:7: *ELEMENT_SHELL card 1, field 5 (N3) = 9, expected the id of a *NODE of the "
          "deck");
    CHECK(contains(faults[2],
                   "deck.k:8: *ELEMENT_SHELL card 2, field 3 (N1) = 1, expected no node twice"));
    CHECK(faults[3] ==
          "deck.k:11: *PART card 2, field 3 (MID) = 5, expected the id of a *MAT of the deck");
    CHECK(faults[4] == "deck.k:14: *SECTION_SHELL card 2, field 1 (T1) = -0.3, expected > 0");
    CHECK(faults[5] == "deck.k:16: *MAT_ELASTIC card 1, field 2 (RO) = 0.0, expected > 0");
    CHECK(faults[6] == "deck.k:17: *DEFINE_CRUVE is not supported, did you mean *DEFINE_CURVE?");
    CHECK(faults[7] ==
          "deck.k:20: *CONTROL_TIMESTEP card 1, field 2 (TSSFAC) = 1.5, expected > 0 and <= 1");
    CHECK(faults[8] == "deck.k:23: *CONTROL_TERMINATION is missing, expected ENDTIM > 0");
    CHECK(faults[9] ==
          "more.k:3: *NODE card 2, field 1 (NID) = 7, expected an id that no other *NODE "
          "has, but more.k:2 has it");
}

TEST_CASE("a keyword that is not supported is a fault, or a note when it cannot matter", "[io]") {
    const DeckFolder folder;
    const auto faults =
        folder.faults(small_deck("*ELEMENT_TSHELL\n1,1\n*CONSTRAINED_JOINT_PLANAR\n1,2\n"
                                 "*ELEMENT_SHELL_MCID\n*FROBNICATE\n"
                                 "*PRAT\nx\n*MAT_FABIRC_TITLE\nx\n"));
    REQUIRE(faults.size() == 6);
    CHECK(contains(faults[0], "deck.k:30: *ELEMENT_TSHELL"));
    CHECK(contains(faults[1], "*CONSTRAINED_JOINT_PLANAR is not supported yet"));
    CHECK(contains(faults[2], "*ELEMENT_SHELL_MCID is not acted on yet"));
    CHECK(faults[3] == "deck.k:35: *FROBNICATE is not supported");
    CHECK(contains(faults[4], "did you mean *PART?"));
    CHECK(contains(faults[5], "did you mean *MAT_FABRIC?"));
    CHECK(folder.faults(small_deck("*MAT_003\n2,7800.\n")).empty());  // nothing is of it
    const auto used =
        folder.faults(small_deck("*MAT_003\n2,7800.\n1,2,3\n*PART\nsteel\n3,1,2\n*ELEMENT_SHELL\n"
                                 "14,3,2,5,6,6\n15,3,2,6,3,3\n"));
    REQUIRE(used.size() == 1);
    CHECK(used[0] ==
          "deck.k:30: *MAT_003 is not supported yet, and 2 elements of part 3 \"steel\" "
          "are of it");
    const Model model = folder.read(small_deck(
        "*CONTROL_OUTPUT\n1\n*DATABASE_EXTENT_BINARY\n1\n*CONTROL_IMPLICIT_GENERAL\n0\n"));
    CHECK(model.warnings.empty());
    REQUIRE(model.notes.size() == 4);
    CHECK(contains(model.notes[0], "units are not known"));
    CHECK(any_contains(folder.read(small_deck("*DATABASE_GLSTTA\n1\n")).notes,
                       "cannot change the answer (did you mean *DATABASE_GLSTAT?)"));
    CHECK(any_contains(folder.read(small_deck("*DATABASE_JNTFORC\n1\n")).notes, "/history/joint"));
    CHECK(any_contains(folder.faults(small_deck("*CONSTRAINED_JOINT_REVOLUTE_FAILURE\n1,2,3,4\n")),
                       "no suffix but ID: a joint here is exact and does not break"));
    CHECK(any_contains(folder.read(small_deck("*DATABASE_BINARY_INTFOR\n1\n")).notes,
                       "contact pressure is in every frame"));
}

TEST_CASE("too few cards are a fault, and so are too many", "[io]") {
    const DeckFolder folder;
    const auto few = folder.faults(small_deck("*MAT_RIGID\n2,1000.,1e9,0.3\n"));
    REQUIRE(few.size() == 1);
    CHECK(few[0] == "deck.k:31: *MAT_RIGID ends before its card 2, expected CMO CON1 CON2");
    const auto many = folder.faults(small_deck("*DAMPING_GLOBAL\n0,1.0\n\n0,2.0\n"));
    REQUIRE(many.size() == 1);
    CHECK(many[0] == "deck.k:33: *DAMPING_GLOBAL card 3 = 0,2.0, expected no more cards");
    CHECK(folder.faults(small_deck("*MAT_FABRIC\n")).size() == 1);
    CHECK(folder.faults(small_deck("*AIRBAG_PARTICLE\n")).size() == 1);
}

TEST_CASE("a table with many bad rows shows some and counts the rest", "[io]") {
    const DeckFolder folder;
    std::string rows = "*NODE\n";
    for (int i = 0; i < 1000; ++i) rows.append("x").append(std::to_string(i)).append(",0,0,0\n");
    const auto faults = folder.faults(small_deck(rows));
    REQUIRE(faults.size() == 21);
    CHECK(contains(faults[0], "deck.k:30: *NODE has 980 more faults that are not shown"));
}

TEST_CASE("faults of one cause are one line with a count, those that follow from it none", "[io]") {
    const DeckFolder folder;
    std::string shells = "*ELEMENT_SHELL\n";
    for (int i = 0; i < 20; ++i) shells += std::to_string(20 + i) + ",9,1,2,3,3\n";
    const auto missing = folder.faults(small_deck(shells));
    REQUIRE(missing.size() == 1);
    CHECK(missing[0] ==
          "deck.k:31: *ELEMENT_SHELL card 1, field 2 (PID) = 9, expected the id of a "
          "*PART of the deck (and 19 more like it)");
    // parts of a set that are missing are one line, of two sets alike too
    const auto parts =
        folder.faults(small_deck("*SET_PART_LIST\n7\n1,11,12,13\n*SET_PART_LIST\n8\n1,11,12,13\n"));
    REQUIRE(parts.size() == 1);
    CHECK(parts[0] ==
          "deck.k:32: *SET_PART_LIST card 2, field 2 (ID2) = 11, expected the id of a *PART of the "
          "deck, nor are there 12, 13 (and 1 more like it)");
    // a set that is refused is no second fault where it is named
    const auto refused = folder.faults(
        small_deck("*SET_PART_LIST_SMOOTH\n7\n1,2\n*CONTACT_AIRBAG_SINGLE_SURFACE\n7,0,2\n\n\n"));
    REQUIRE(refused.size() == 1);
    CHECK(contains(refused[0], "*SET_PART_LIST_SMOOTH is not acted on yet"));
}

TEST_CASE("numbers beyond the last column of a card are warned of, remarks are not", "[io]") {
    const DeckFolder folder;
    std::string row;
    for (int i = 0; i < 9; ++i) row += "         1";
    const Model model = folder.read(small_deck("*SET_PART_LIST\n7\n" + row + "\n"));
    REQUIRE(model.warnings.size() == 1);
    CHECK(contains(model.warnings[0],
                   "deck.k:32: *SET_PART_LIST card 2: \"1\" beyond column 80 is ignored"));
    CHECK(folder.read(small_deck("*SET_PART_LIST\n7\n" + row.substr(0, 80) + " all parts\n"))
              .warnings.empty());
}

TEST_CASE("numbers that are none, too large, or not finite are faults", "[io]") {
    const DeckFolder folder;
    for (const char* number :
         {"nan", "inf", "1e999", "1e101", "12abc", "1 2", "99999999999", "1.5"}) {
        CAPTURE(number);
        const std::string deck =
            small_deck("*DATABASE_HISTORY_NODE\n" + std::string(number) + ",1\n");
        CHECK(folder.faults(deck).size() == 1);
    }
    const auto prose = folder.faults(small_deck("*LOAD_BODY_Z\n7, 0   gravity is off\n"));
    REQUIRE(prose.size() == 1);
    CHECK(contains(prose[0], "field 2 (SF) = 0   gravity is off, expected a number"));
}

TEST_CASE("a deck without a mesh, and text before the first keyword, are faults", "[io]") {
    const DeckFolder folder;
    CHECK(any_contains(folder.faults("*CONTROL_TERMINATION\n1.0\n"), "*ELEMENT_SHELL is missing"));
    CHECK(any_contains(folder.faults("hello\n" + small_deck()), "deck.k:1: expected a *KEYWORD"));
    CHECK_FALSE(folder.faults("").empty());
}

TEST_CASE("a field that is read twice is at fault once, and every unknown keyword is named",
          "[io]") {
    const DeckFolder folder;
    const auto once = folder.faults(small_deck("*BOUNDARY_SPC_NODE\n1,0,x\n"));
    REQUIRE(once.size() == 1);
    CHECK(contains(once[0], "field 3 (DOFX) = x, expected a whole number"));
    std::string unknown;
    for (char c = 'A'; c <= 'Y'; ++c) unknown += std::string("*QQQQQQ_") + c + "\n1\n";
    CHECK(folder.faults(small_deck(unknown)).size() == 25);
}

TEST_CASE("faults that only the whole scene shows get file, line and keyword", "[io]") {
    const DeckFolder folder;
    io::DeckPlaces places;
    const auto deck = folder.write("deck.k", small_deck("*CONTACT_AIRBAG_SINGLE_SURFACE_ID\n"
                                                        "7,all\n0,0,5\n\n\n"));
    const Model model = io::read_deck(deck, {}, &places);
    const std::string shell = "shell " + std::to_string(model.shells[0].id) + " has no area";
    const std::string told = folder.bare(places.told(shell));
    CHECK(contains(told, "deck.k:"));
    CHECK(contains(told, ": *ELEMENT_SHELL: " + shell));
    CHECK(contains(folder.bare(places.told("contact 7: too thick")),
                   "*CONTACT_AIRBAG_SINGLE_SURFACE_ID: contact 7: too thick"));
    CHECK(places.told("contact 8: is none") == "contact 8: is none");
    const auto many = places.told(std::vector<std::string>{
        "shell 98: is bad", "shell 99: is bad", "shell 97: is bad", "shell 98: is worse"});
    CHECK(many ==
          std::vector<std::string>{"shell 98: is bad (and 2 more like it)", "shell 98: is worse"});
}

TEST_CASE("typed faults of a scene are told in the deck's words", "[io]") {
    const auto told = [](Fault fault) {
        return io::DeckPlaces().told(InputError(std::move(fault))).faults.at(0);
    };
    const Fault vent{.of = "*AIRBAG_PARTICLE 1",
                     .property = Property::VENT_WALL,
                     .which = "vent 2",
                     .why = "no shell of it is in the bag"};
    CHECK(vent.text() == "*AIRBAG_PARTICLE 1, wall of vent 2: no shell of it is in the bag");
    CHECK(told(vent) == "*AIRBAG_PARTICLE 1, SID3 of vent 2: no shell of it is in the bag");
    const Fault modulus{.of = "material 17",
                        .property = Property::SHEAR_MODULUS,
                        .value = 0.0,
                        .why = "expected > 0"};
    CHECK(modulus.text() == "material 17: shear modulus = 0, expected > 0");
    CHECK(told(modulus) == "material 17: GAB = 0, expected > 0");
    Fault wall{.of = "*AIRBAG_PARTICLE 1", .property = Property::CLOSING_WALL, .why = "open"};
    CHECK(told(wall) == "*AIRBAG_PARTICLE 1, SID1: open");
    wall.of = "*AIRBAG_WANG_NEFSKE 2";
    CHECK(told(wall) == "*AIRBAG_WANG_NEFSKE 2, SID: open");
    CHECK(told({.of = {}, .why = "shell 3 has no area"}) == "shell 3 has no area");
    CHECK(told({.of = "bag 1", .why = "is not closed"}) == "bag 1: is not closed");
}

TEST_CASE("every property that can be at fault has a name", "[io]") {
    for (int p = 1; p < static_cast<int>(Property::COUNT); ++p)
        CHECK_FALSE(name_of(static_cast<Property>(p)).empty());
}

TEST_CASE("settings in a comment are those of -D, which goes before them", "[io]") {
    const DeckFolder folder;
    const std::string cloth = "*MAT_FABRIC\n7,800.,3e8\n\n\n\n\n";
    CHECK(folder.read("$ corpuscle: UNITS = lbf-in-s, CLOSE = no\n" + small_deck(cloth))
              .unit_system == "lbf-in-s-K");
    CHECK_FALSE(folder.read("$# corpuscle: CLOSE=no\n" + small_deck("")).closes_bags);
    CHECK_FALSE(folder.read("\xEF\xBB\xBF$ corpuscle: CLOSE = no\n" + small_deck("")).closes_bags);
    io::DeckOptions options;
    options.overrides = {{"UNITS", "g-mm-ms"}};
    CHECK(folder.read("$ corpuscle: UNITS = SI\n" + small_deck(""), options).unit_system ==
          "g-mm-ms-K");
    CHECK(folder.read("$ for corpuscle: a remark\n" + small_deck(cloth)).unit_system == "SI");
    const auto faults = folder.faults("$\n$ corpuscle: UNIT = SI\n" + small_deck(""));
    REQUIRE(faults.size() == 1);
    CHECK(contains(faults[0], "deck.k:2: $ corpuscle: UNIT = SI, expected NAME = VALUE"));
    CHECK(contains(folder.faults("$ corpuscle: UNITS = stone\n" + small_deck("")).at(0),
                   "UNITS = stone, expected SI, kg-mm-ms-K, ton-mm-s-K, g-mm-ms-K or lbf-in-s-K"));
}
