// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Layers of parts; shells that would vanish or begin with stress; typed parameters; cases.

#include <catch2/catch.hpp>

#include "tests/unit/io/deck/included/inclusion_setup.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("layers of one material are one section of all their thicknesses", "[io]") {
    const Model model = read_small(
        "*MAT_FABRIC\n9,800,1e8,0,0,0.3\n\n\n\n\n*PART_COMPOSITE\nlaminate\n9,5\n"
        "9,0.1,0.0,0,9,0.2,0.0\n9,0.15\n*PART_COMPOSITE\nisotropic\n8,9\n1,0.1,45,0,1,0.2,-45\n");
    REQUIRE(model.parts.size() == 4);
    CHECK(model.parts[2].id == 9);
    CHECK(model.parts[2].title == "laminate");
    CHECK(model.parts[2].thickness == Approx(0.45));
    CHECK(model.parts[2].element_form == 5);
    CHECK(model.materials[static_cast<std::size_t>(model.parts[2].material)].id == 9);
    CHECK(model.parts[3].thickness == Approx(0.3));
    CHECK(model.parts[3].material == model.parts[0].material);
}

TEST_CASE("layers that are not one sheet are refused by field", "[io]") {
    const auto fault = [](const std::string& cards) {
        return only_fault("*MAT_FABRIC\n9,800,1e8,0,0,0.3\n\n\n\n\n*PART_COMPOSITE\nlaminate\n" +
                          cards + "\n");
    };
    CHECK(contains(fault("9,5\n9,0.1,0,0,1,0.2"), "card 3, field 5 (MID2) = 1, expected 9"));
    CHECK(contains(fault("9,5\n9,0.1\n9,0.2,45"), "card 4, field 3 (B1) = 45, expected 0: an"));
    CHECK(contains(fault("9,5\n9"), "field 2 (THICK1)"));
    CHECK(contains(fault("9,5,0,0.5\n9,0.1"), "card 2, field 4 (NLOC) = 0.5, expected "));
    CHECK(contains(fault("9,5"), "has no layers, expected rows of MID, THICK and B"));
}

TEST_CASE("shells vanish after the run at the earliest", "[io]") {
    const std::string set = "*SET_SHELL\n5\n11,12\n";
    const Model model = read_small(set +
                                   "*DEFINE_ELEMENT_DEATH_SHELL_SET_TITLE\nlate\n5,1.0\n"
                                   "*DEFINE_ELEMENT_DEATH_SHELL\n13,2.0,0,0,1,0,50\n");
    CHECK(any_contains(model.notes, "is after the run: the shells stay"));
    CHECK(contains(only_fault(set + "*DEFINE_ELEMENT_DEATH_SHELL_SET\n5,0.9\n"),
                   "field 2 (TIME) = 0.9, expected 1 or above, the end of the run"));
    CHECK(contains(only_fault("*DEFINE_BOX\n3,0,1,0,1,0,1\n*DEFINE_ELEMENT_DEATH_SHELL\n13,2,3\n"),
                   "field 3 (BOXID) = 3, expected blank"));
    CHECK(contains(only_fault("*DEFINE_ELEMENT_DEATH_SHELL\n99,2\n"), "field 1 (SID) = 99"));
    const DeckFolder folder;
    io::DeckOptions longer;
    longer.until = 3.0;
    CHECK(folder.faults(small_deck("*DEFINE_ELEMENT_DEATH_SHELL\n13,2.0\n"), longer).size() == 1);
}

TEST_CASE("stress at the start that is 0 everywhere is none", "[io]") {
    const std::string keyword = "*INITIAL_STRESS_SHELL\n";
    const std::string narrow = "11,1,2,9\n-0.5\n\n\n0.5,0,0,0\n\n\n13\n0\n";
    CHECK(any_contains(read_small(keyword + narrow).notes, "its stresses are all 0"));
    const std::string wide =
        "        11         1         1         1         0         1\n"
        "    5.000000E-01    0.000000E+00    0.000000E+00    0.000000E+00    0.000000E+00\n"
        "    0.000000E+00    0.000000E+00    0.000000E+00\n    0.000000E+00\n";
    CHECK(any_contains(read_small(keyword + wide).notes, "its stresses are all 0"));
    CHECK(contains(only_fault(keyword + "11\n0,0,7.0\n"),
                   "card 2, field 3 (SIGYY) = 7.0, expected 0: shells begin with the stress of "
                   "their reference geometry alone"));
    CHECK(contains(only_fault(keyword + "11,1,1,1\n\n0.1\n"), "card 3, field 1 (HISV1) = 0.1"));
    CHECK(contains(only_fault("*SET_SHELL\n5\n11\n*INITIAL_STRESS_SHELL_SET\n5\n0,0,0,0,0,0,0,1\n"),
                   "field 8 (EPS) = 1"));
    CHECK(contains(only_fault(keyword + "11,1,1,0,6\n0\n"), "field 5 (NTENSR) = 6"));
}

TEST_CASE("a typed parameter is an integer that is shifted where it is used", "[io]") {
    const std::string file = small_deck(
        "*PARAMETER_TYPE\nI    node         3       NID\nI  curve,7,CURVEID\n"
        "*BOUNDARY_SPC_NODE\n&node,0,1\n*LOAD_NODE_POINT\n&node,1,&curve\n");
    const Model model = read_included(file, inclusion("file.k", EACH_OFFSET));
    REQUIRE(model.supports.size() == 1);
    CHECK(model.node_id[static_cast<std::size_t>(model.supports[0].node)] == 1003);
    CHECK(model.curves[static_cast<std::size_t>(model.node_loads.at(0).curve)].id == 6007);
}

TEST_CASE("cases of one deck are refused with what is expected", "[io]") {
    const DeckFolder folder;
    const auto faults = folder.faults(
        small_deck("*CASE\n1\n*CASE_BEGIN_1\n*BOUNDARY_SPC_NODE\n3,0,1\n*CASE_END_1\n"));
    REQUIRE(faults.size() == 3);
    for (const std::string& fault : faults)
        CHECK(contains(fault, "expected the keywords of that case alone"));
}
