// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Keywords that have no influence here, those of which that is not sure, and text that cannot be
// read.

#include <catch2/catch.hpp>

#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::string LEVEL_FLOOR = "*RIGIDWALL_PLANAR\n0\n0,0,-1,0,0,0\n";
const std::string STOPS = "stops 3 nodes of rigid bodies too";

}  // namespace

TEST_CASE("what has no influence is a note", "[io]") {
    const std::string cards =
        GENERATE("*ELEMENT_PLOTEL\n1,1,2\n", "*RIGIDWALL_FORCE_TRANSDUCER\n1\n1\n",
                 "*DEFINE_MATERIAL_HISTORIES\nDamage\n", "*DEFINE_TRACER_PARTICLES_2D\n1\n",
                 "*DEFINE_BOX_ADAPTIVE\n1,0,1,0,1,0,1\n1\n", "*DEFINE_CONNECTION_PROPERTIES\n1\n",
                 "*DEFINE_HAZ_PROPERTIES\n1\n", "*DEFINE_SPOTWELD_RUPTURE_STRESS\n1\n",
                 "*DEFINE_CONSTRUCTION_STAGES\n1\n", "*SET_BOX\n1\n", "*SET_MODE_LIST\n1\n1\n",
                 "*SENSOR_CONTROL\n1,BELTPRET,1\n1\n", "*MAT_ADD_EROSION\n1,0,0,0\n",
                 "*MAT_ADD_EROSION_TITLE\nfails\n5,-1,2,-1\n-1,3\n*MAT_NULL\n5,1\n");
    CAPTURE(cards);
    const Model model = read_small(cards);
    CHECK(model.warnings.empty());
    CHECK((any_contains(model.notes, "is not used") ||
           any_contains(model.notes, "it cannot change the answer")));
}

TEST_CASE("what could have an influence is a fault or a warning", "[io]") {
    CHECK(contains(only_fault("*SENSOR_CONTROL\n1,AIRBAG,1\n1\n"), "(TYPE) = AIRBAG, expected"));
    CHECK(contains(only_fault("*MAT_ADD_EROSION\n1,0,0,0\n0,5.0\n"),
                   "(MID) = 1, expected a material that is in no membrane"));
    CHECK(any_contains(read_small("*DAMPING_FREQUENCY_RANGE_DEFORM\n0.01,1,2,1\n").warnings,
                       "is left out"));
    CHECK(any_contains(read_small("*CONTROL_TIMESTEP\n0,0.9,0,0,0,7\n").warnings,
                       "(LCTM) = 7: this upper bound of the step is not kept"));
    const std::string section =
        GENERATE("*SECTION_TSHELL\n5,1\n", "*SECTION_SPH\n5\n", "*SECTION_ALE1D\n5,1\n1\n",
                 "*SECTION_POINT_SOURCE\n5,1,2,3\n");
    CHECK(read_small(section).warnings.empty());
    CHECK(contains(only_fault(section + "*PART\ncloth\n4,5,1\n*ELEMENT_SHELL\n92,4,1,2,3,3\n"),
                   "expected a *SECTION_SHELL or *SECTION_SOLID"));
}

TEST_CASE("walls that stop rigid bodies although RWPNAL is 0 are told", "[io]") {
    CHECK(any_contains(read_small(RIGID_TRIANGLE + LEVEL_FLOOR).notes, STOPS));
    CHECK(any_contains(read_small(RIGID_TRIANGLE + LEVEL_FLOOR + "*CONTROL_CONTACT\n0.1\n").notes,
                       STOPS));
    const Model asked =
        read_small(RIGID_TRIANGLE + LEVEL_FLOOR + "*CONTROL_CONTACT\n0.1,1.0\n0\n0\n");
    CHECK_FALSE(any_contains(asked.notes, STOPS));
    CHECK_FALSE(any_contains(asked.notes, "*CONTROL_CONTACT is not read"));
    CHECK_FALSE(any_contains(read_small(LEVEL_FLOOR).notes, "of rigid bodies too"));
}

TEST_CASE("a nodal rigid body of masses alone", "[io]") {
    const auto body = [](const std::string& masses) {
        return read_small(
            "*NODE\n200,0,0,50\n201,0,30,60\n202,40,0,60\n*SET_NODE\n9\n200,201,202\n"
            "*CONSTRAINED_NODAL_RIGID_BODY\n9\n" +
            masses);
    };
    CHECK(body("*ELEMENT_MASS\n1,200,0.1\n2,201,0.1\n3,202,0.1\n").rigid_extra_nodes.size() == 3);
    CHECK(contains(only_fault("*SET_NODE\n9\n1\n*CONSTRAINED_NODAL_RIGID_BODY\n9\n"),
                   "rigid part 9 has all of its mass in one place"));
    const Model none = body("");
    CHECK(none.rigid_extra_nodes.empty());
    CHECK(any_contains(none.warnings, "is left out: nothing that has mass is at its nodes"));
}

TEST_CASE("sets by ranges of sets and by boxes", "[io]") {
    const std::string sets = "*SET_NODE\n11\n1\n*SET_NODE\n12\n2\n*SET_NODE\n13\n3\n";
    const auto members = [](const std::string& cards) {
        const Model model = read_small(cards + "*BOUNDARY_SPC_SET\n20,0,1,1,1\n");
        std::vector<Index> nodes;
        for (const Support& support : model.supports) nodes.push_back(support.node);
        return nodes;
    };
    CHECK(members(sets + "*SET_NODE_ADD\n20\n11,-13\n") == std::vector<Index>{0, 1, 2});
    CHECK(members("*SET_NODE_ADD\n20\n12,-14\n" + sets + "*SET_NODE_ADD\n14\n11\n") ==
          std::vector<Index>{1, 2, 0});
    CHECK(members("*DEFINE_BOX\n1,-1,0.5,-1,2,-1,1\n*SET_NODE_GENERAL\n20\nBOX,1\n") ==
          std::vector<Index>{0, 3});
    CHECK(contains(only_fault(sets + "*SET_NODE_ADD\n20\n-13\n"),
                   "(ID1) = -13, expected the id of a set, or minus one"));
}

TEST_CASE("text that cannot be read is one fault, and what it may define none", "[io]") {
    const DeckFolder folder;
    const auto only = [&](const std::string& text) {
        const auto faults = folder.faults(text);
        CAPTURE(faults);
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    const std::string scene =
        "*KEYWORD\n*BOUNDARY_SPC_SET\n1,0,1,1,1\n*CONTACT_AIRBAG_SINGLE_SURFACE\n5,0,2\n\n\n"
        "*MAT_FABRIC\n1,700,1e8,1e8,0,0.3\n1e7\n0,-7,-8\n\n\n";
    CHECK(contains(only(scene + "*INCLUDE\nnot_there.k\n"), "expected a file that can be read"));
    CHECK(contains(only(scene + "*INCLUDE_AUTO_OFFSET\nmesh.k\n"), "is not supported"));
    const std::string secret =
        "-----BEGIN PGP MESSAGE-----\nVersion: GnuPG v1.4.6\n\nhQEMA5lJ0gJ\n=abcd\n"
        "-----END PGP MESSAGE-----\n";
    const std::string before = GENERATE("*NODE\n", "*SET_PART_LIST\n1\n1,2\n", "*MAT_FOAM\n", "");
    CHECK(contains(only(scene + before + secret + "*END\n"), "encrypted keywords (PGP)"));
    CHECK(contains(only(secret + scene), "deck.k:1: encrypted keywords (PGP)"));
    CHECK(contains(only(std::string("\xFF\xFE*\0K\0", 6)),
                   "deck.k:1: expected text of single bytes"));
    CHECK(contains(only("*KEYWORD\r*END\r"), "deck.k:1: expected lines that end with LF"));
    folder.write("cr.k", "*NODE\r1,0,0,0\r");
    CHECK(contains(only(scene + "*INCLUDE\ncr.k\n"), "cr.k, expected lines that end with LF"));
}
