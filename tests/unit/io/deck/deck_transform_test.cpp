// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

const std::string NODES =
    "*NODE\n101,1,0,0\n102,0,2,0\n103,0,0,3\n104,5,5,5\n"
    "*SET_NODE_LIST\n9\n101,102,103,101\n";

/// Places of nodes 101 to 104 after the lines of a transformation.
std::vector<Vec3> placed(const std::string& lines) {
    const DeckFolder folder;
    const Model model = folder.read(
        small_deck(NODES + "*NODE_TRANSFORM\n7,9\n*DEFINE_TRANSFORMATION\n7\n" + lines));
    return {model.x.end() - 4, model.x.end()};
}

void check_at(const Vec3& x, const Vec3& expected) {
    INFO(x.transpose() << ", expected " << expected.transpose());
    CHECK((x - expected).norm() < 1e-12);
}

}  // namespace

TEST_CASE("a translation moves the nodes of its set once and no others", "[deck]") {
    const auto x = placed("TRANSL,10,20,30\n");
    check_at(x[0], {11, 20, 30});
    check_at(x[1], {10, 22, 30});
    check_at(x[2], {10, 20, 33});
    check_at(x[3], {5, 5, 5});
}

TEST_CASE("a rotation turns right-handed about an axis through a place", "[deck]") {
    auto x = placed("ROTATE,0,0,2,0,0,0,90\n");
    check_at(x[0], {0, 1, 0});
    check_at(x[1], {-2, 0, 0});
    check_at(x[2], {0, 0, 3});
    x = placed("ROTATE,0,0,1,1,1,0,180\n");
    check_at(x[0], {1, 2, 0});
    CHECK(placed("ROTATE,1,2,3,4,5,6,0\n") == placed("TRANSL,0,0,0\n"));
}

TEST_CASE("lines of a transformation act in their order", "[deck]") {
    check_at(placed("SCALE,2,3,0\nROTATE,0,0,1,0,0,0,90\nTRANSL,1,0,0\n")[1], {-5, 0, 0});
    check_at(placed("TRANSL,1,0,0\nROTATE,0,0,1,0,0,0,90\nSCALE,2,3,0\n")[1], {-4, 3, 0});
}

TEST_CASE("rows of a transformation that say too little are refused", "[deck]") {
    const auto fault = [](const std::string& row) {
        return only_fault(NODES + "*DEFINE_TRANSFORMATION\n7\n" + row);
    };
    CHECK(contains(fault("ROTATE,0,0,0,1,1,1,5\n"), "an axis"));
    CHECK(contains(fault("ROTATE,0,0,1,1,1,1\n"), "(A7) = blank"));
    CHECK(contains(fault("SCALE,1e-12\n"), "a factor of 1e-09 to 1e+09"));
    CHECK(
        contains(fault("SHEAR,1\n"),
                 "(OPTION) = SHEAR, expected TRANSL, TRANSL2ND, SCALE, ROTATE, ROTATE3NA, MIRROR, "
                 "POINT, POS6P or POS6N"));
    CHECK(contains(only_fault(NODES + "*NODE_TRANSFORM\n7,9\n"), "TRSID"));
}

TEST_CASE("nodes from which a mass was found are not moved behind its back", "[deck]") {
    const std::string body =
        "*DEFINE_TRANSFORMATION\n7\nTRANSL,1,1,1\n*NODE_TRANSFORM\n7,9\n"
        "*MAT_RIGID\n5,2.0,1.e9,0.3\n\n\n*PART_INERTIA\nhead\n50,1,5\n"
        "0,0,0,4.0,0,102\n1,0,0,1,0,1\n\n*ELEMENT_SHELL\n91,50,101,102,103,103\n";
    CHECK(only_fault(NODES + body).find("node 102 is one") != std::string::npos);
}
