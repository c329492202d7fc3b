// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rows of *DEFINE_TRANSFORMATION that name points, nodes and planes.

#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Three nodes that are moved, and three that are not.
const std::string SIX_NODES =
    "*NODE\n101,1,0,0\n102,1,2,0\n103,1,0,3\n104,5,5,5\n105,6,5,5\n106,5,6,5\n"
    "*SET_NODE_LIST\n9\n101,102,103\n";

Points moved_nodes(const std::string& rows) {
    const Model model =
        read_small(SIX_NODES + "*NODE_TRANSFORM\n7,9\n*DEFINE_TRANSFORMATION\n7\n" + rows);
    return {model.x.end() - 6, model.x.end() - 3};
}

void check_places(const Points& x, const Points& expected) {
    for (std::size_t i = 0; i < x.size(); ++i) {
        INFO(i << ": " << x[i].transpose() << ", expected " << expected[i].transpose());
        CHECK((x[i] - expected[i]).norm() < 1e-12);
    }
}

std::string fault_of(const std::string& rows) {
    return only_fault(SIX_NODES + "*NODE_TRANSFORM\n7,9\n*DEFINE_TRANSFORMATION\n7\n" + rows);
}

}  // namespace

TEST_CASE("a mirror reflects in a plane through a place", "[deck]") {
    check_places(moved_nodes("MIRROR,0,2,0,0,7,0\n"), {{1, 4, 0}, {1, 2, 0}, {1, 4, 3}});
    check_places(moved_nodes("MIRROR,0,0,0,1,1,0,1\n"), {{0, -1, 0}, {-2, -1, 0}, {0, -1, 3}});
    check_places(moved_nodes("SCALE,-1,1,1\n"), moved_nodes("MIRROR,0,0,0,3,0,0\n"));
    CHECK(contains(fault_of("MIRROR,1,2,3,1,2,3\n"), "(A4) = 1, expected a place away from A1-A3"));
}

TEST_CASE("a rotation by two points is one about the line through them", "[deck]") {
    const std::string points = "POINT,1,1,0,0\nPOINT,2,1,0,5\n";
    check_places(moved_nodes(points + "ROTATE,1,2,90\n"), moved_nodes("ROTATE,0,0,1,1,0,0,90\n"));
    check_places(moved_nodes(points + "ROTATE,2,1,90,0,0,0,0\n"),
                 moved_nodes("ROTATE,0,0,1,1,0,0,-90\n"));
    CHECK(contains(fault_of("POINT,1,0,0,0\nROTATE,1,2,90\n"),
                   "(A2) = 2, expected the id of a POINT row above"));
    CHECK(contains(fault_of("POINT,2,0,0,1\nROTATE,1,2,90\nPOINT,1,0,0,0\n"), "POINT row above"));
    CHECK(contains(fault_of("POINT,1,0,0,0\nPOINT,1,0,0,1\n"), "no other POINT"));
    CHECK(
        contains(fault_of("POINT,1,0,0,0\nPOINT,2,0,0,0\nROTATE,1,2,3\n"), "away from the first"));
}

TEST_CASE("points move with all rows before the one that names them, wherever they stand",
          "[deck]") {
    const std::string behind = "TRANSL,10,0,0\nPOINT,1,1,0,0\nPOINT,2,1,0,5\nROTATE,1,2,90\n",
                      before = "POINT,1,1,0,0\nPOINT,2,1,0,5\nTRANSL,10,0,0\nROTATE,1,2,90\n";
    const Points expected = moved_nodes("TRANSL,10,0,0\nROTATE,0,0,1,11,0,0,90\n");
    check_places(moved_nodes(behind), expected);
    check_places(moved_nodes(before), expected);
}

TEST_CASE("a rotation by an angle of zero about a written axis turns nothing", "[deck]") {
    check_places(moved_nodes("ROTATE,0,0,1,0,0,0,0\n"), moved_nodes("TRANSL,0,0,0\n"));
}

TEST_CASE("six points or nodes: the first onto the fourth, line onto line, plane onto plane",
          "[deck]") {
    const Points expected = {{5, 5, 5}, {7, 5, 5}, {5, 8, 5}};
    const std::string points =
        "POINT,1,1,0,0\nPOINT,2,1,2,0\nPOINT,3,1,0,3\nPOINT,4,5,5,5\nPOINT,5,6,5,5\n"
        "POINT,6,5,6,5\n";
    check_places(moved_nodes(points + "POS6P,1,2,3,4,5,6\n"), expected);
    check_places(moved_nodes("POS6N,101,102,103,104,105,106\n"), expected);
    // the start moves with the rows before, the target stays
    check_places(moved_nodes("ROTATE,1,2,3,4,5,6,40\nPOS6N,101,102,103,104,105,106\n"), expected);
    check_places(moved_nodes(points + "ROTATE,1,2,3,4,5,6,40\nPOS6P,1,2,3,4,5,6\n"), expected);
    CHECK(contains(fault_of(points + "POS6P,1,2,2,4,5,6\n"),
                   "(A1) = 1, expected three POINTs that span a plane"));
    CHECK(contains(fault_of("POS6N,101,102,102,104,105,106\n"),
                   "POS6N, expected three nodes that span a plane"));
    CHECK(contains(fault_of("POS6N,101,102,103,104,105,107\n"), "(A6) = 107, expected the id"));
}

TEST_CASE("two nodes give the direction of a translation, three the axis of a rotation", "[deck]") {
    check_places(moved_nodes("TRANSL2ND,104,105,4\n"), moved_nodes("TRANSL,4,0,0\n"));
    check_places(moved_nodes("TRANSL2ND,101,104\n"), moved_nodes("TRANSL,4,5,5\n"));
    check_places(moved_nodes("ROTATE3NA,104,105,101,30\n"), moved_nodes("ROTATE,1,0,0,1,0,0,30\n"));
    // a node that is moved is where the rows before have put it
    check_places(moved_nodes("TRANSL,0,7,0\nROTATE3NA,104,105,102,30\n"),
                 moved_nodes("TRANSL,0,7,0\nROTATE,1,0,0,1,9,0,30\n"));
    CHECK(contains(fault_of("TRANSL2ND,104,104,4\n"), "TRANSL2ND, expected two nodes apart"));
    CHECK(contains(fault_of("ROTATE3NA,104,104,101,4\n"), "ROTATE3NA, expected two nodes apart"));
}
