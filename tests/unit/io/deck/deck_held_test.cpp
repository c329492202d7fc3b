// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// A rigid plate of nodes 101-104 in the plane z = 5, and one of the same material in z = 6.
const std::string PLATES = R"(*MAT_RIGID
5,2.0,1.e9,0.3


*PART
plate
50,1,5
*PART
other
51,1,5
*NODE
101,0,0,5
102,1,0,5
103,1,1,5
104,0,1,5
201,0,0,6
202,1,0,6
203,1,1,6
204,0,1,6
*ELEMENT_SHELL
21,50,101,102,103,104
22,51,201,202,203,204
*SET_NODE
8
101,102,103
*DEFINE_CURVE
77
0,1
1,1
)";

const fabric::RigidCard& card_of(const Model& model, int part) {
    for (const Part& p : model.parts)
        if (p.id == part) return std::get<fabric::RigidCard>(model.materials[p.material].card);
    throw std::logic_error("no such part");
}

/// Rows of *BOUNDARY_SPC_SET, or _NODE, hold the plate along and about these axes, and no node.
void check_held(const std::string& rows, unsigned moves, unsigned turns) {
    CAPTURE(rows);
    const Model model = read_small(PLATES + rows);
    CHECK(card_of(model, 50).fixed_moves == moves);
    CHECK(card_of(model, 50).fixed_turns == turns);
    CHECK(card_of(model, 51).fixed_moves == 0);
    CHECK(card_of(model, 51).fixed_turns == 0);
    CHECK(model.supports.empty());
    CHECK(any_contains(model.notes, "*PART 50: supports of its nodes (first node 101) hold"));
}

}  // namespace

TEST_CASE("supports of a rigid body's nodes hold the body", "[io][rigid]") {
    check_held("*BOUNDARY_SPC_SET\n8,0,1,1,1\n", 7, 7);
    check_held("*BOUNDARY_SPC_SET\n8,0,0,0,1\n", 4, 3);
    check_held("*BOUNDARY_SPC_NODE\n101,0,1,1,1,1,1,1\n", 7, 7);
    check_held("*BOUNDARY_SPC_NODE\n101,0,0,0,0,1,1,0\n", 0, 3);
    check_held("*BOUNDARY_SPC_NODE\n101,0,1,1,0,1,1,1\n", 3, 7);
}

TEST_CASE("supports that make a hinge of a rigid body are refused", "[io][rigid]") {
    for (const std::string rows :
         {"101,0,1,1,1\n", "101,0,1,1,1\n102,0,1,1,1\n", "101,0,0,0,1\n"}) {
        const std::string fault = only_fault(PLATES + "*BOUNDARY_SPC_NODE\n" + rows);
        CAPTURE(rows, fault);
        CHECK(contains(fault, "*PART 50 is rigid and held by *BOUNDARY_SPC or TC at nodes"));
        CHECK(contains(fault, "expected CON1 and CON2 of its *MAT_RIGID"));
    }
}

TEST_CASE("nodes of rigid bodies are not moved one by one", "[io][rigid]") {
    CHECK(contains(only_fault(PLATES + "*BOUNDARY_PRESCRIBED_MOTION_SET\n8,3,0,77\n"),
                   "moves node 101 of rigid part 50, expected *BOUNDARY_PRESCRIBED_MOTION_RIGID"));
}

TEST_CASE("two motions along one axis at one time are refused, one of what is held is told",
          "[io][motion]") {
    const std::string rigid = "*BOUNDARY_PRESCRIBED_MOTION_RIGID\n";
    CHECK(
        contains(only_fault(PLATES + rigid + "50,3,0,77\n50,3,0,77,2\n"), "moves part 50, which "));
    CHECK(contains(only_fault(PLATES + "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,77\n1,1,2,77\n"),
                   "moves node 1, which "));
    const auto warnings = [](const std::string& rows) {
        return read_small(PLATES + rows).warnings;
    };
    CHECK_FALSE(
        any_contains(warnings(rigid + "50,3,0,77\n50,2,0,77\n50,6,0,77\n"), "motion counts"));
    CHECK_FALSE(any_contains(warnings(rigid + "50,3,0,77,1,0,0.5\n50,3,0,77,1,0,1,0.5\n"),
                             "motion counts"));
    CHECK(any_contains(warnings("*BOUNDARY_SPC_NODE\n1,0,1\n*BOUNDARY_PRESCRIBED_MOTION_NODE\n"
                                "1,1,0,77\n"),
                       "node 1 is held along that axis: this motion counts"));
    CHECK(any_contains(warnings("*BOUNDARY_SPC_SET\n8,0,0,0,1\n" + rigid + "50,3,0,77\n"),
                       "*PART 50 is held along that axis: this motion counts"));
}

TEST_CASE("curves of loads and motions that do not last are told", "[io][motion]") {
    const auto warned = [](const std::string& curve, const std::string& row) {
        return any_contains(read_small(PLATES + "*DEFINE_CURVE\n79\n" + curve + row).warnings,
                            "keeps its value 3");
    };
    const std::string motion = "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,79\n";
    CHECK(warned("0,1\n0.5,3\n", motion));
    CHECK(warned("0.1,3\n1,1\n", motion));
    CHECK(warned("0,3\n0.5,3\n", "*LOAD_BODY_Z\n79\n"));
    CHECK(warned("0,3\n0.5,3\n", "*LOAD_NODE_POINT\n1,1,79\n"));
    CHECK(warned("0,3\n0.5,3\n", "*LOAD_SHELL_ELEMENT\n11,79\n"));
    CHECK_FALSE(warned("0,3\n1,3\n", motion));
    CHECK_FALSE(warned("0,1\n0.5,0\n", motion));
    CHECK_FALSE(warned("0,1\n0.5,3\n", "*BOUNDARY_PRESCRIBED_MOTION_NODE\n1,1,0,79,1,0,0.5\n"));
}
