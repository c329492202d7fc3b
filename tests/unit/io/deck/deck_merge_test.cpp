// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *DEFINE_COORDINATE_..., local constraints of *MAT_RIGID, *CONSTRAINED_RIGID_BODIES.

#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

std::string held(const std::string& constraints, const std::string& system) {
    return "*MAT_RIGID\n5,2.0,1.e9,0.3\n" + constraints + "\n\n" + system;
}

const fabric::RigidCard& card(const Model& model) {
    return std::get<fabric::RigidCard>(model.materials.at(1).card);
}

/// local x along y, local y along -x
Mat3 quarter_turn() {
    Mat3 axes;
    axes << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    return axes;
}

/// Quads 20 and 21 of the rigid parts 50 and 51, which a unit square each are apart.
const std::string TWO =
    "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*PART\nlead\n50,1,5\n*PART\nled\n51,1,5\n"
    "*NODE\n21,0,0,5\n22,1,0,5\n23,1,1,5\n24,0,1,5\n"
    "31,2,0,5\n32,3,0,5\n33,3,1,5\n34,2,1,5\n"
    "*ELEMENT_SHELL\n20,50,21,22,23,24\n21,51,31,32,33,34\n";
const std::string MERGED = TWO + "*CONSTRAINED_RIGID_BODIES\n50,51\n";

}  // namespace

TEST_CASE("CMO = -1: axes by places, vectors and nodes, a digit for each that is held", "[io]") {
    const std::string code = "-1,9,101001";
    // the deck's order does not matter
    const Model by_places =
        read_small(held(code, "*DEFINE_COORDINATE_SYSTEM\n9,1,1,0,1,4,0\n0,2,0\n"));
    CHECK((card(by_places).axes - quarter_turn()).norm() < 1e-15);
    CHECK(card(by_places).fixed_moves == 0b101U);  // x, z
    CHECK(card(by_places).fixed_turns == 0b100U);  // about z
    const Model by_vectors =
        read_small(held(code, "*DEFINE_COORDINATE_VECTOR_TITLE\nrail\n9,0,3,0,-1,5,0\n"));
    CHECK((card(by_vectors).axes - quarter_turn()).norm() < 1e-15);
    const Model by_nodes = read_small(held(code, "*DEFINE_COORDINATE_NODES\n9,2,3,1\n"));
    CHECK((card(by_nodes).axes - quarter_turn()).norm() < 1e-15);
    const Model low = read_small(held("-1.0,9,111", "*DEFINE_COORDINATE_NODES\n9,2,3,1\n"));
    CHECK(card(low).fixed_moves == 0U);  // 000111
    CHECK(card(low).fixed_turns == 0b111U);
    CHECK(card(read_small(held("1,7,7", ""))).axes == Mat3(Mat3::Identity()));
}

TEST_CASE("nodes that are placed by a transformation give axes where they end", "[io]") {
    const std::string nodes = "*NODE\n61,0,0,0\n62,1,0,0\n63,0,1,0\n*SET_NODE\n6\n61,62,63\n";
    const Model model =
        read_small(held("-1,9,100000", "*DEFINE_COORDINATE_NODES\n9,61,62,63\n" + nodes +
                                           "*DEFINE_TRANSFORMATION\n3\nROTATE,0,0,1,0,0,0,90\n"
                                           "*NODE_TRANSFORM\n3,6\n"));
    CHECK((card(model).axes - quarter_turn()).norm() < 1e-12);
}

TEST_CASE("what is wrong with local constraints is told", "[io]") {
    const std::string good = "*DEFINE_COORDINATE_SYSTEM\n9,0,0,0,1,0,0\n0,1,0\n";
    CHECK(contains(only_fault(held("-1,8,111", good)), "(CON1) = 8"));
    CHECK(contains(only_fault(held("-1,9,120000", good)), "(CON2) = 120000"));
    CHECK(contains(only_fault(held("-1,9,102", good)), "six digits, each 0 or 1"));
    CHECK(contains(only_fault("*DEFINE_COORDINATE_SYSTEM\n9,0,0,0,1,0,0\n5,0,0\n"),
                   "span the local xy plane"));
    CHECK(contains(only_fault("*DEFINE_COORDINATE_NODES\n9,1,2,5\n"), "a node off the line"));
    CHECK(contains(only_fault("*DEFINE_COORDINATE_NODES\n9,1,2,3,0,Y\n"), "(DIR)"));
    CHECK(contains(only_fault("*DEFINE_COORDINATE_SYSTEM\n9,0,0,0,1,0,0,4\n0,1,0\n"), "(CIDL)"));
}

TEST_CASE("merged parts: lead, inertia, extra nodes on any of them", "[io]") {
    const Model model = read_small(MERGED + "*CONSTRAINED_EXTRA_NODES_NODE\n51,22\n50,6\n");
    REQUIRE(model.rigid_merges.size() == 1);
    CHECK(model.rigid_merges[0].lead == 2);
    CHECK(model.rigid_merges[0].part == 3);
    CHECK_FALSE(model.rigid_merges[0].keeps_inertia);
    REQUIRE(model.rigid_extra_nodes.size() == 1);  // 22 is the lead's own

    const std::string inertia =
        "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*PART_INERTIA\nlead\n50,1,5\n"
        "1,2,3,4.5\n1,0,0,2,0,2.5\n\n*PART\nled\n51,1,5\n"
        "*CONSTRAINED_RIGID_BODIES\n50,51,";
    CHECK(read_small(inertia + "0\n").rigid_merges.at(0).keeps_inertia);
    CHECK_FALSE(read_small(inertia + "1\n").rigid_merges.at(0).keeps_inertia);
}

TEST_CASE("merged parts start with the momentum and angular momentum of their nodes", "[io]") {
    // the lead moves at 3 along y, the other rests: a mass of 0.6 each, centres 2 apart
    const Model model = read_small(MERGED + "*INITIAL_VELOCITY_GENERATION\n50,2,0,0,3,0\n\n");
    const auto start = starts_of(model);
    REQUIRE(start.size() == 1);
    CHECK(start[0].part == 2);
    CHECK((start[0].velocity - Vec3(0, 1.5, 0)).norm() < 1e-12);
    const double m = 0.6, turning = -m * 1.5 - m * 1.5;  // sum of m x (v - V)
    const double inertia = 2.0 * (m * 0.5 + m * 1.0);    // of the corners, and of the centres
    CHECK((start[0].spin - Vec3(0, 0, turning / inertia)).norm() < 1e-12);
    // a field of all: as it is
    const auto all = starts_of(read_small(MERGED + "*INITIAL_VELOCITY\n\n1,2,3\n"));
    REQUIRE(all.size() == 1);
    CHECK((all[0].velocity - Vec3(1, 2, 3)).norm() < 1e-12);
    CHECK(all[0].spin.norm() < 1e-12);
}

TEST_CASE("gravity pulls all of a merged body alike, by one card or several", "[io]") {
    const std::string load = MERGED + "*LOAD_GRAVITY_PART\n";
    for (const char* rows : {"50,3,7,9.81\n51,3,7,9.81\n", "50,3,7,9\n51,3,7,4\n51,3,7,5\n",
                             "51,3,0,9.81\n50,3,0,9.81\n50,1,7,2\n51,1,7,2\n"})
        CHECK(read_small(load + rows).body_loads.size() >= 2);
    for (const char* rows : {"50,3,7,9.81\n", "51,3,7,9.81\n", "50,3,7,9\n51,3,7,8\n",
                             "50,3,7,9\n51,2,7,9\n", "50,3,7,9\n51,3,0,9\n"})
        CHECK(contains(only_fault(load + rows), "*PART 51 is merged with others"));
    // nodes that are joined to a body have no mass of their own
    CHECK(read_small(TWO + "*SET_NODE\n6\n21,5\n*CONSTRAINED_NODAL_RIGID_BODY\n60,0,6\n"
                           "*LOAD_GRAVITY_PART\n50,3,7,9.81\n")
              .rigid_merges.size() == 1);
}

TEST_CASE("what is wrong with merged parts is told", "[io]") {
    const std::string merge = "*CONSTRAINED_RIGID_BODIES\n";
    CHECK(contains(only_fault(TWO + merge + "1,51\n"), "(PIDL) = 1, expected a part with"));
    CHECK(contains(only_fault(TWO + merge + "50,1\n"), "(PIDC) = 1, expected a part with"));
    CHECK(contains(only_fault(TWO + merge + "50,50\n"), "a part that does not lead PIDL"));
    CHECK(contains(only_fault(MERGED + "51,50\n"), "a part that does not lead PIDL"));
    CHECK(contains(only_fault(MERGED + "50,51\n"), "a part that no other leads yet"));
    CHECK(contains(only_fault(MERGED + "*INITIAL_VELOCITY_RIGID_BODY\n51,1,0,0\n"),
                   "part 50, which leads the merged body"));
    CHECK(contains(only_fault(MERGED + "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n51,1,0,7\n"),
                   "part 50, which leads the merged body"));
    CHECK(contains(only_fault("*MAT_RIGID\n6,2.0,1.e9,0.3\n1,7,7\n\n*PART\nheld\n52,1,6\n" + TWO +
                              merge + "50,52\n"),
                   "the lead's constraints count"));
    const DeckFolder folder;
    CHECK(any_contains(folder.faults(small_deck(TWO + "*CONSTRAINED_RIGID_BODIES_SET\n50,51\n")),
                       "*CONSTRAINED_RIGID_BODIES_SET is not acted on yet"));
}
