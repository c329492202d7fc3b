// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "contact/planar_wall.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

PlanarWallCard wall_card(std::size_t nodes, double friction = 0.0) {
    PlanarWallCard card;
    card.normal = Vec3(1, 0, 2).normalized();
    card.point = Vec3(0.3, 0.2, 0.1);
    card.friction = friction;
    for (std::size_t i = 0; i < nodes; ++i) card.nodes.push_back(static_cast<Index>(i));
    return card;
}

constexpr double DT = 1e-5;

}  // namespace

TEST_CASE("a node stops at the wall, and the wall feels its momentum", "[contact]") {
    const PlanarWallCard card = wall_card(1);
    PlanarWall wall(card);
    const std::vector<double> mass{2e-3};
    Points x{card.point + 1.7e-3 * card.normal}, v{-50.0 * card.normal};
    const double kinetic = 0.5 * mass[0] * 2500.0;
    Vec3 impulse = Vec3::Zero();
    for (int n = 0; n < 20; ++n) {
        wall.hold(x, mass, n * DT, DT, v);
        x[0] += DT * v[0];
        impulse += DT * wall.force();
        REQUIRE(card.normal.dot(x[0] - card.point) > -1e-15);
    }
    CHECK(card.normal.dot(x[0] - card.point) < 1e-15);
    CHECK(v[0].norm() < 1e-9);
    CHECK((impulse + 0.1 * card.normal).norm() < 1e-12);
    CHECK(wall.stopping_energy() == Approx(kinetic).epsilon(1e-12));
    CHECK(wall.friction_energy() == 0.0);
}

TEST_CASE("a wall lets go of what leaves it", "[contact]") {
    const PlanarWallCard card = wall_card(1);
    PlanarWall wall(card);
    const std::vector<double> mass{1.0};
    const Points x{card.point};
    Points v{3.0 * card.normal};
    wall.hold(x, mass, 0.0, DT, v);
    CHECK(v[0] == 3.0 * card.normal);
    CHECK(wall.force().isZero());
}

TEST_CASE("sliding along a wall: free, rubbed by mu times the normal impulse, or stuck",
          "[contact]") {
    const Vec3 along = Vec3(2, 0, -1).normalized();
    const double friction = GENERATE(0.0, 0.3, 1.0);
    const PlanarWallCard card = wall_card(1, friction);
    PlanarWall wall(card);
    const std::vector<double> mass{0.5};
    const Points x{card.point};
    Points v{-10.0 * card.normal + 8.0 * along};
    wall.hold(x, mass, 0.0, DT, v);
    const double left = friction == 0.0 ? 8.0 : friction == 0.3 ? 5.0 : 0.0;
    CHECK((v[0] - left * along).norm() < 1e-12);
    CHECK(wall.stopping_energy() == Approx(0.25 * 100.0));
    CHECK(wall.friction_energy() == Approx(0.25 * (64.0 - left * left)).margin(1e-12));
    CHECK(wall.force().dot(along) * DT == Approx(0.5 * (8.0 - left)).margin(1e-12));
}

TEST_CASE("nodes behind the wall at its birth are named and let alone until they come out",
          "[contact]") {
    PlanarWallCard card = wall_card(2);
    card.birth = 1e-3;
    PlanarWall wall(card);
    const std::vector<double> mass{1.0, 1.0};
    Points x{card.point - 1e-3 * card.normal, card.point + 1e-3 * card.normal};
    Points v{-5.0 * card.normal, -500.0 * card.normal};
    const Points before = v;
    wall.hold(x, mass, 0.0, DT, v);
    CHECK(v == before);  // not yet born
    wall.hold(x, mass, 1e-3, DT, v);
    CHECK(wall.nodes_behind() == std::vector<Index>{0});
    CHECK(v[0] == before[0]);
    CHECK(v[1].dot(card.normal) == Approx(-100.0));

    x[0] = card.point + 1e-6 * card.normal;
    wall.hold(x, mass, 2e-3, DT, v);
    CHECK(wall.nodes_behind().empty());
    CHECK(v[0].dot(card.normal) == Approx(-0.1));
}
