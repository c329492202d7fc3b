// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/roughness.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <memory>

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

constexpr double ROUGH_TIME = 1e-3, ROUGH_STEP = 1e-5;

/// Two parts of one right-angled triangle each, of area 1/2.
BagWalls two_triangles() {
    BagWalls walls;
    walls.triangles = {{0, 1, 2}, {2, 1, 3}};
    walls.part = {0, 1};
    walls.part_ids = {11, 12};
    walls.part_rows = {4, 5};
    walls.closing = 2;
    return walls;
}
const Points X{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};

std::shared_ptr<const WettedSurface> surface_of(const BagWalls& walls, const Points& x) {
    return std::make_shared<WettedSurface>(walls.triangles, walls.closing, x);
}

Roughness rough(const BagCard& card, const std::vector<Curve>& curves = {}) {
    const BagWalls walls = two_triangles();
    return {card, walls, surface_of(walls, X), curves, ROUGH_TIME};
}

}  // namespace

TEST_CASE("a bag without friction has none on any facet", "[gas]") {
    const Roughness roughness = rough(BagCard{});
    CHECK(roughness.now().on(1) == 0.0);
    CHECK(roughness.now().of_side.empty());
}

TEST_CASE("a part's own friction goes before that of all", "[gas]") {
    BagCard card;
    card.friction = {{{}, 0.2}, {{5}, -0.5}};
    card.friction_pushes_along = false;
    const Roughness roughness = rough(card);
    CHECK(roughness.now().on(0) == 0.2);
    CHECK(roughness.now().on(1) == -0.5);
    CHECK_FALSE(roughness.now().pushes_along);
}

TEST_CASE("friction by a curve follows the mean pressure of its own part's hits and the air",
          "[gas]") {
    BagCard card;
    card.friction = {{{5}, 0.0, 0}};
    const std::vector<Curve> curves{{1, {0.0, 1000.0}, {0.0, 1.0}}};
    Roughness roughness = rough(card, curves);
    constexpr double PRESSURE = 300.0, OF_AIR = 200.0;
    FlightResult flight;
    flight.hits = {{{0, 0, {1, 0, 0}, Vec3(0, 0, 7.0), 0.0, Vec3::Zero()}},
                   {{1, 0, {1, 0, 0}, Vec3(0, 0, 0.5 * PRESSURE * ROUGH_STEP), 0.0, Vec3::Zero()}}};
    flight.hits[1][0].impulse += Vec3(0.01, -0.02, 0.0);  // along the fabric: no pressure
    const auto surface = surface_of(two_triangles(), X);
    WallHits hits(*surface);
    hits.list(flight, X, X);
    double before = 0.0;
    for (int s = 1; s <= 1000; ++s) {
        roughness.receive(flight, hits, ROUGH_STEP, std::array{OF_AIR}, X);
        if (s == 100) before = roughness.now().on(1);  // one ROUGH_TIME: 1 - 1/e of the way
    }
    CHECK(before == Approx((OF_AIR + PRESSURE * (1.0 - std::exp(-1.0))) / 1000.0));
    CHECK(roughness.now().on(1) == Approx((OF_AIR + PRESSURE) / 1000.0).epsilon(1e-3));
    CHECK(roughness.now().on(0) == 0.0);
}

namespace {

/// Two tetrahedra on each other, parts 0 and 1, with one triangle between them, part 2.
struct TwoRooms {
    BagWalls walls;
    Points x{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.3, 0.3, 1}, {0.3, 0.3, -1}};

    TwoRooms() {
        walls.triangles = {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {1, 0, 4},
                           {2, 1, 4}, {0, 2, 4}, {0, 1, 2}};
        walls.part = {0, 0, 0, 1, 1, 1, 2};
        walls.part_ids = {1, 2, 3};
        walls.part_rows = {0, 1, 2};
        walls.closing = 6;
    }
};

}  // namespace

TEST_CASE("a wall between two rooms is as rough on each side as the pressure there asks", "[gas]") {
    const TwoRooms bag;
    const auto surface = surface_of(bag.walls, bag.x);
    REQUIRE(surface->rooms() == 2);
    const auto above = static_cast<std::size_t>(surface->room(surface->side(6, true)));
    REQUIRE(above == static_cast<std::size_t>(surface->room(surface->side(0, false))));
    BagCard card;
    card.friction = {{{}, 0.0, 0}};
    const std::vector<Curve> curves{{1, {0.0, 1000.0}, {0.0, 1.0}}};
    Roughness roughness(card, bag.walls, surface, curves, ROUGH_TIME);
    constexpr double ABOVE = 300.0, BELOW = 40.0;
    std::array<double, 2> air{20.0, 20.0};
    air[above] = 100.0;
    FlightResult flight;  // a hit of each side: pressure is along the normal, from above down
    flight.hits = {{{6, 0, {1, 0, 0}, Vec3(0, 0, -0.5 * ABOVE * ROUGH_STEP), 0.0, Vec3::Zero()},
                    {6, 1, {1, 0, 0}, Vec3(0, 0, 0.5 * BELOW * ROUGH_STEP), 0.0, Vec3::Zero()}}};
    WallHits hits(*surface);
    hits.list(flight, bag.x, bag.x);
    for (int s = 1; s <= 2000; ++s) roughness.receive(flight, hits, ROUGH_STEP, air, bag.x);
    const WallFriction now = roughness.now();
    CHECK(now.has_sides(6));
    CHECK(now.on(6, true) == Approx((100.0 + ABOVE) / 1000.0));
    CHECK(now.on(6, false) == Approx((20.0 + BELOW) / 1000.0));
    for (const Index facet : {0, 1, 2}) CHECK(now.on(facet) == Approx(0.1));
    for (const Index facet : {3, 4, 5}) CHECK(now.on(facet) == Approx(0.02));
}

TEST_CASE("a membrane within one room feels the mean pressure of its two sides", "[gas]") {
    BagWalls walls;  // a tetrahedron, and a triangle in it
    walls.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {4, 5, 6}};
    walls.part = {0, 0, 0, 0, 1};
    walls.part_ids = {1, 2};
    walls.part_rows = {0, 1};
    walls.closing = 4;
    const Points x{{-9, -9, -9}, {9, -9, -9}, {0, 9, -9}, {0, 0, 9},
                   {0, 0, 0},    {1, 0, 0},   {0, 1, 0}};
    const auto surface = surface_of(walls, x);
    REQUIRE(surface->rooms() == 1);
    BagCard card;
    card.friction = {{{1}, 0.0, 0}};
    const std::vector<Curve> curves{{1, {0.0, 1000.0}, {0.0, 1.0}}};
    Roughness roughness(card, walls, surface, curves, ROUGH_TIME);
    constexpr double PRESSURE = 200.0;
    FlightResult flight;
    for (const double way : {-0.5, 0.5})
        flight.hits.push_back(
            {{4, 0, {1, 0, 0}, Vec3(0, 0, way * PRESSURE * ROUGH_STEP), 0.0, Vec3::Zero()}});
    WallHits hits(*surface);
    hits.list(flight, x, x);
    const std::array<double, 1> none{};
    for (int s = 1; s <= 2000; ++s) roughness.receive(flight, hits, ROUGH_STEP, none, x);
    CHECK(roughness.now().on(4, true) == Approx(PRESSURE / 1000.0));
    CHECK(roughness.now().on(4, false) == Approx(PRESSURE / 1000.0));
}
