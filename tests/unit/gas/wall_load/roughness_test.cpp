// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/roughness.hpp"

#include <catch2/catch.hpp>

#include <cmath>

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

}  // namespace

TEST_CASE("a bag without friction has none on any facet", "[gas]") {
    const Roughness roughness(BagCard{}, two_triangles(), {}, ROUGH_TIME);
    CHECK(roughness.now().on(1) == 0.0);
    CHECK(roughness.now().of_facet.empty());
}

TEST_CASE("a part's own friction goes before that of all", "[gas]") {
    BagCard card;
    card.friction = {{{}, 0.2}, {{5}, -0.5}};
    card.friction_pushes_along = false;
    const Roughness roughness(card, two_triangles(), {}, ROUGH_TIME);
    CHECK(roughness.now().on(0) == 0.2);
    CHECK(roughness.now().on(1) == -0.5);
    CHECK_FALSE(roughness.now().pushes_along);
}

TEST_CASE("friction by a curve follows the mean pressure of its own part's hits and the air",
          "[gas]") {
    BagCard card;
    card.friction = {{{5}, 0.0, 0}};
    const std::vector<Curve> curves{{1, {0.0, 1000.0}, {0.0, 1.0}}};
    Roughness roughness(card, two_triangles(), curves, ROUGH_TIME);
    constexpr double PRESSURE = 300.0, OF_AIR = 200.0;
    FlightResult flight;
    flight.hits = {{{0, 0, {1, 0, 0}, Vec3(0, 0, 7.0), 0.0, Vec3::Zero()}},
                   {{1, 0, {1, 0, 0}, Vec3(0, 0, 0.5 * PRESSURE * ROUGH_STEP), 0.0, Vec3::Zero()}}};
    flight.hits[1][0].impulse += Vec3(0.01, -0.02, 0.0);  // along the fabric: no pressure
    double before = 0.0;
    for (int s = 1; s <= 1000; ++s) {
        roughness.receive(flight, ROUGH_STEP, OF_AIR, X);
        if (s == 100) before = roughness.now().on(1);  // one ROUGH_TIME: 1 - 1/e of the way
    }
    CHECK(before == Approx((OF_AIR + PRESSURE * (1.0 - std::exp(-1.0))) / 1000.0));
    CHECK(roughness.now().on(1) == Approx((OF_AIR + PRESSURE) / 1000.0).epsilon(1e-3));
    CHECK(roughness.now().on(0) == 0.0);
}
