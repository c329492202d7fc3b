// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "deck_scene.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using contact::WallCard;

namespace {

WallCard wall(const std::string& text) {
    const DeckFolder folder;
    const Model model = folder.read(small_deck(text));
    REQUIRE(model.walls.size() == 1);
    return model.walls[0];
}

template <class Shape>
Shape shape(const std::string& text) {
    return std::get<Shape>(wall(text).shape);
}

}  // namespace

TEST_CASE("a finite plane starts at the tail, along its edge and across", "[io]") {
    const auto plate =
        shape<contact::Plate>("*RIGIDWALL_PLANAR_FINITE\n\n1,2,3,1,2,5\n1,9,3,0.5,0\n");
    CHECK(plate.corner == Vec3(1, 2, 3));
    CHECK(plate.axes.col(0) == Vec3::UnitY());
    CHECK(plate.axes.col(1) == -Vec3::UnitX());
    CHECK(plate.axes.col(2) == Vec3::UnitZ());
    CHECK(plate.low[0] == 0.0);
    CHECK(plate.high[0] == 0.5);
    CHECK(plate.low[1] == -INF);
    CHECK(plate.high[1] == INF);
    const auto flat =
        shape<contact::Plate>("*RIGIDWALL_GEOMETRIC_FLAT\n\n1,2,3,1,2,5\n1,9,3,0.5,0.25\n");
    CHECK(flat.axes == plate.axes);
    CHECK(flat.high[1] == 0.25);
    const auto endless = shape<contact::HalfSpace>("*RIGIDWALL_GEOMETRIC_FLAT\n\n1,2,3,1,2,5\n\n");
    CHECK(endless.normal == Vec3::UnitZ());
}

TEST_CASE("a moving plane: mass, speed, output, pictures", "[io]") {
    const WallCard card = wall(
        "*RIGIDWALL_PLANAR_MOVING_FORCES_DISPLAY_ID\n9,sled\n\n0,0,-1,0,-2,-1,0.3\n"
        "80,-5\n0,4,1,2,3\n7,1e-9,2e5,0.3\n");
    CHECK(card.id == 9);
    CHECK(card.motion.direction == -Vec3::UnitY());
    CHECK(card.motion.mass == 80.0);
    CHECK(card.motion.speed == -5.0);
    CHECK(card.motion.curve == -1);
    CHECK(card.friction == 0.3);
    CHECK(wall("*RIGIDWALL_PLANAR_MOVING\n\n0,0,-1,0,0,1\n\n").motion.direction.isZero());
}

TEST_CASE("OFFSET without a set takes the nodes near the plane", "[io]") {
    const WallCard card = wall("*RIGIDWALL_PLANAR\n0,0,0,1.2\n-0.5,0,0,1,0,0\n");
    CHECK(card.nodes == std::vector<Index>{0, 3});
    const DeckFolder folder;
    const Model model = folder.read(
        small_deck("*SET_NODE\n5\n1,5\n*RIGIDWALL_PLANAR\n5,0,0,1.2\n-0.5,0,0,1,0,0\n"));
    CHECK(model.walls.at(0).nodes == std::vector<Index>{0, 4});
    CHECK(any_contains(model.warnings, "(OFFSET) = 1.2: counts only without NSID"));
}

TEST_CASE("sphere, cylinder and prism", "[io]") {
    const auto ball = shape<contact::Ball>("*RIGIDWALL_GEOMETRIC_SPHERE\n\n1,2,3\n0.4\n");
    CHECK(ball.centre == Vec3(1, 2, 3));
    CHECK(ball.radius == 0.4);
    const auto rod = shape<contact::Rod>("*RIGIDWALL_GEOMETRIC_CYLINDER\n\n1,2,3,4,2,3\n0.4,2.5\n");
    CHECK(rod.base == Vec3(1, 2, 3));
    CHECK(rod.axis == Vec3::UnitX());
    CHECK(rod.radius == 0.4);
    CHECK(rod.low == 0.0);
    CHECK(rod.high == 2.5);
    const auto endless = shape<contact::Rod>("*RIGIDWALL_GEOMETRIC_CYLINDER\n\n1,2,3,4,2,3\n0.4\n");
    CHECK(endless.low == -INF);
    CHECK(endless.high == INF);
    const auto block =
        shape<contact::Brick>("*RIGIDWALL_GEOMETRIC_PRISM\n\n0,0,0,0,0,1\n3,0,0,1,2,4\n");
    CHECK(block.axes == Mat3::Identity());
    CHECK(block.low == Vec3(0, 0, -4));
    CHECK(block.high == Vec3(1, 2, 0));
}

TEST_CASE("walls that a curve moves, born and gone", "[io]") {
    const WallCard card = wall(
        "*RIGIDWALL_GEOMETRIC_SPHERE_MOTION_DISPLAY\n0,0,0,0.1,0.7\n1,2,3,0,0,0,0.5\n0.4\n"
        "7,1,0.6,0,-0.8\n");
    CHECK(card.birth == 0.1);
    CHECK(card.death == 0.7);
    CHECK(card.motion.curve == 0);
    CHECK(card.motion.is_displacement);
    CHECK((card.motion.direction - Vec3(0.6, 0, -0.8)).norm() < 1e-15);
    CHECK(wall("*RIGIDWALL_GEOMETRIC_SPHERE\n\n1,2,3\n0.4\n").motion.direction.isZero());
}

TEST_CASE("what is wrong with a wall is told by card and field", "[io]") {
    const DeckFolder folder;
    const auto only = [&](const std::string& text) {
        const auto faults = folder.faults(small_deck(text));
        REQUIRE(faults.size() == 1);
        return faults[0];
    };
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_SPHERE\n\n1,2,3\n-0.4\n"), "(RADSPH) = -0.4"));
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_SPHERE\n0,0,3\n1,2,3\n0.4\n"), "(BOXID) = 3"));
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_CYLINDER\n\n1,2,3,4,2,3\n0.4,1,2\n"),
                   "(NSEGS) = 2, expected 0"));
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_CYLINDER\n\n1,2,3,1,2,3\n0.4,1\n"),
                   "a head away from the tail"));
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n\n1,2,3\n0.4\n7,0,0,0,2\n"),
                   "the cosines of a direction"));
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_SPHERE_MOTION\n\n1,2,3\n0.4\n7,2,0,0,1\n"),
                   "(OPT) = 2"));
    CHECK(contains(only("*RIGIDWALL_PLANAR_FINITE\n\n0,0,0,0,0,1\n1,0,1,2,2\n"),
                   "square to the normal"));
    CHECK(contains(only("*RIGIDWALL_PLANAR_MOVING\n\n0,0,0,0,0,1\n-1,2\n"), "(MASS) = -1"));
    CHECK(contains(only("*RIGIDWALL_GEOMETRIC_FLAT_INTERIOR\n\n"), "is not acted on yet"));
}
