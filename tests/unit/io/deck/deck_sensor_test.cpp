// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("DATABASE_CPM_SENSOR: a sphere, a cylinder or a box at every segment", "[io]") {
    using Shape = gas::SensorCard::Shape;
    const DeckFolder folder;
    const std::string set = "*SET_SEGMENT\n3\n1,2,3,3\n2,5,6,3\n";
    const auto deck = [&](const std::string& rows) {
        return small_deck(set + "*DATABASE_CPM_SENSOR\n1e-3\n" + rows);
    };
    const Model model = folder.read(deck("3,-0.1,0.2\n3,0.1,0.2,0.3\n3,0,0.1,0.2,0.4\n"));
    REQUIRE(model.sensors.size() == 6);
    CHECK(model.sensors[0].shape == Shape::SPHERE);
    CHECK(model.sensors[0].offset == -0.1);
    CHECK(model.sensors[1].nodes == std::array<Index, 4>{1, 4, 5, 2});
    CHECK(model.sensors[2].shape == Shape::CYLINDER);
    CHECK(model.sensors[3].size[1] == 0.3);
    CHECK(model.sensors[5].shape == Shape::BOX);
    CHECK(model.output.cpm_sensor == 1e-3);
    CHECK(contains(folder.faults(deck("3,0,0\n")).at(0), "(R/LX)"));
    CHECK(contains(folder.faults(deck("3,0,0.1,0,0.2\n")).at(0), "(LEN/LY) = 0, expected > 0"));
    CHECK(contains(folder.faults(deck("4,0,0.1\n")).at(0), "(SEGSID) = 4"));
    CHECK(contains(folder.faults(deck("")).at(0), "has no sensor"));
}

TEST_CASE("definitions on which nothing acts are notes where nothing refers to them", "[io]") {
    for (const char* text :
         {"*DEFINE_FUNCTION\n9,friction\nf(p)=0.1*p\n",
          "*DEFINE_FUNCTION_TABULATED\n9\nf\n0,1\n1,1\n", "*DEFINE_TABLE\n9\n0.0\n",
          "*SET_2D_SEGMENT\n9\n1\n", "*SENSOR_DEFINE_NODE\n9,1,2\n",
          "*SENSOR_SWITCH\n9,SENSOR,9,GT,0.1\n"}) {
        const Model model = read_small(text);
        CAPTURE(text, model.notes);
        CHECK(any_contains(model.notes, "is not used: nothing that is read refers to it"));
        CHECK(model.warnings.empty());
    }
}

TEST_CASE("what refers to a definition on which nothing acts is a fault that names both", "[io]") {
    const std::string function = "*DEFINE_FUNCTION_TITLE\nby time\n9,f\nf(t)=t\n";
    CHECK(contains(only_fault(function + "*LOAD_BODY_Z\n9,1.0\n"),
                   "deck.k:35: *LOAD_BODY_Z card 1, field 1 (LCID) = 9, expected the id of a "
                   "*DEFINE_CURVE of the deck; 9 is a *DEFINE_FUNCTION_TITLE ("));
    CHECK(
        contains(only_fault("*DEFINE_TABLE\n9\n0.0\n*MAT_FABRIC\n2,700.,1.e8\n,\n0,-9,1\n,\n,\n"),
                 "(FLC) = -9, expected >= 0, or minus the id of a *DEFINE_CURVE of the deck; 9 is "
                 "a *DEFINE_TABLE (deck.k:30), on which nothing acts yet"));
    const std::string flat = "*SET_2D_SEGMENT\n9\n1\n";
    CHECK(contains(only_fault(flat + "*LOAD_SEGMENT_SET\n9,7\n"), "9 is a *SET_2D_SEGMENT"));
    CHECK(contains(only_fault(flat + "*SET_SEGMENT_ADD\n5\n9\n"), "9 is a *SET_2D_SEGMENT"));
    CHECK(contains(only_fault("*SENSOR_CONTROL\n1,CONTACT,1\n"), "sensors switch nothing here"));
}

TEST_CASE("belts' devices, other ends of the run and local axes of nodes are warned of", "[io]") {
    const auto warned = [](const std::string& text, const std::string& of) {
        const Model model = read_small(text);
        CAPTURE(text, model.warnings);
        REQUIRE(model.warnings.size() == 1);
        CHECK(contains(model.warnings[0], of));
        return model;
    };
    warned("*ELEMENT_SEATBELT_RETRACTOR\n1,0,3,1\n0,0,0,0\n", "is left out, as belts are");
    warned("*TERMINATION_SENSOR\n1\n", "it goes on to ENDTIM");
    CHECK(warned("*DATABASE_HISTORY_NODE_LOCAL\n3,1,0\n1,0,0\n", "(CID) = 1").history_nodes ==
          std::vector<Index>{0, 2});
    CHECK(read_small("*DATABASE_HISTORY_NODE_LOCAL_ID\n3,0,0\nhead\n1\nfoot\n").history_nodes ==
          std::vector<Index>{0, 2});
    CHECK(read_small("*SET_NODE\n5\n2,4\n*DATABASE_HISTORY_NODE_SET_LOCAL\n5\n").history_nodes ==
          std::vector<Index>{1, 3});
    CHECK(contains(only_fault("*DATABASE_HISTORY_NODE_LOCAL\n77\n"), "(ID) = 77"));
}

TEST_CASE("an accelerometer that weighs nothing is a note", "[io]") {
    const std::string accelerometer = "*ELEMENT_SEATBELT_ACCELEROMETER\n1,1,2,3,0,1";
    CHECK(any_contains(read_small(accelerometer + "\n").notes, "is not written"));
    CHECK(contains(only_fault(accelerometer + ",0.1\n"), "(MASS) = 0.1, expected 0 or blank"));
}
