// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <random>

#include "contact/rigid_walls/rigid_wall.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

const HalfSpace PLANE{Vec3(0.3, 0.2, 0.1), Vec3(1, 0, 2).normalized()};

WallCard wall_card(std::size_t nodes, double friction = 0.0) {
    WallCard card;
    card.shape = PLANE;
    card.friction = friction;
    for (std::size_t i = 0; i < nodes; ++i) card.nodes.push_back(static_cast<Index>(i));
    return card;
}

constexpr double WALL_STEP = 1e-5;

}  // namespace

TEST_CASE("a node stops at the wall, and the wall feels its momentum", "[contact]") {
    const WallCard card = wall_card(1);
    RigidWall wall(card);
    const std::vector<double> mass{2e-3};
    Points x{PLANE.point + 1.7e-3 * PLANE.normal}, v{-50.0 * PLANE.normal};
    const double kinetic = 0.5 * mass[0] * 2500.0;
    Vec3 impulse = Vec3::Zero();
    for (int n = 0; n < 20; ++n) {
        wall.hold(x, mass, n * WALL_STEP, WALL_STEP, v);
        x[0] += WALL_STEP * v[0];
        impulse += WALL_STEP * wall.force();
        REQUIRE(PLANE.normal.dot(x[0] - PLANE.point) > -1e-15);
    }
    CHECK(PLANE.normal.dot(x[0] - PLANE.point) < 1e-15);
    CHECK(v[0].norm() < 1e-9);
    CHECK((impulse + 0.1 * PLANE.normal).norm() < 1e-12);
    CHECK(wall.stopping_energy() == Approx(kinetic).epsilon(1e-12));
    CHECK(wall.friction_energy() == 0.0);
}

TEST_CASE("a wall lets go of what leaves it", "[contact]") {
    const WallCard card = wall_card(1);
    RigidWall wall(card);
    const std::vector<double> mass{1.0};
    const Points x{PLANE.point};
    Points v{3.0 * PLANE.normal};
    wall.hold(x, mass, 0.0, WALL_STEP, v);
    CHECK(v[0] == 3.0 * PLANE.normal);
    CHECK(wall.force().isZero());
}

TEST_CASE("sliding along a wall: free, rubbed by mu times the normal impulse, or stuck",
          "[contact]") {
    const Vec3 along = Vec3(2, 0, -1).normalized();
    const double friction = GENERATE(0.0, 0.3, 1.0);
    const WallCard card = wall_card(1, friction);
    RigidWall wall(card);
    const std::vector<double> mass{0.5};
    const Points x{PLANE.point};
    Points v{-10.0 * PLANE.normal + 8.0 * along};
    wall.hold(x, mass, 0.0, WALL_STEP, v);
    const double left = friction == 0.0 ? 8.0 : friction == 0.3 ? 5.0 : 0.0;
    CHECK((v[0] - left * along).norm() < 1e-12);
    CHECK(wall.stopping_energy() == Approx(0.25 * 100.0));
    CHECK(wall.friction_energy() == Approx(0.25 * (64.0 - left * left)).margin(1e-12));
    CHECK(wall.force().dot(along) * WALL_STEP == Approx(0.5 * (8.0 - left)).margin(1e-12));
}

TEST_CASE("nodes behind the wall at its birth are let alone until they come out", "[contact]") {
    WallCard card = wall_card(2);
    card.birth = 1e-3;
    RigidWall wall(card);
    const std::vector<double> mass{1.0, 1.0};
    Points x{PLANE.point - 1e-3 * PLANE.normal, PLANE.point + 1e-3 * PLANE.normal};
    Points v{-5.0 * PLANE.normal, -500.0 * PLANE.normal};
    const Points before = v;
    wall.hold(x, mass, 0.0, WALL_STEP, v);
    CHECK(v == before);  // not yet born
    wall.hold(x, mass, 1e-3, WALL_STEP, v);
    CHECK(v[0] == before[0]);
    CHECK(v[1].dot(PLANE.normal) == Approx(-100.0));

    x[0] = PLANE.point + 1e-6 * PLANE.normal;
    wall.hold(x, mass, 2e-3, WALL_STEP, v);
    CHECK(v[0].dot(PLANE.normal) == Approx(-0.1));
}

TEST_CASE("nodes that lie on a wall to rounding are held by it", "[contact]") {
    const Vec3 along = PLANE.normal.cross(Vec3::UnitY()).normalized();
    std::mt19937 random(11);
    std::uniform_real_distribution<double> place(-0.3, 0.3), off(-1e-17, 1e-17);
    Points x, v;
    for (int i = 0; i < 40; ++i) {
        x.push_back(PLANE.point + place(random) * along + place(random) * Vec3::UnitY() +
                    off(random) * PLANE.normal);
        v.push_back(-3.0 * PLANE.normal + along);
    }
    x[39] = PLANE.point - 1e-5 * PLANE.normal;
    RigidWall wall(wall_card(x.size()));
    const auto behind = std::count_if(x.begin(), x.end(), [](const Vec3& at) {
        return (at - PLANE.point).dot(PLANE.normal) < 0.0;
    });
    CHECK(behind > 5);
    CHECK(wall.inside(x).nodes == 1);
    CHECK(wall.inside(x).deepest == 39);
    CHECK(wall.inside(x).depth == Approx(1e-5));
    wall.hold(x, std::vector<double>(x.size(), 1.0), 0.0, WALL_STEP, v);
    for (std::size_t i = 0; i < 39; ++i) CHECK(std::abs(v[i].dot(PLANE.normal)) < 1e-10);
    CHECK(v[39].dot(PLANE.normal) == Approx(-3.0));
}

TEST_CASE("a block on an incline sticks below the friction angle and slides above it",
          "[contact]") {
    constexpr double G = 9.81, STEP = 1e-3;
    const double mu = 0.4;
    const double angle = std::atan(mu) + GENERATE(-0.02, 0.02, 0.4);
    WallCard card = wall_card(1, mu);
    card.shape = HalfSpace{Vec3::Zero(), Vec3(-std::sin(angle), 0.0, std::cos(angle))};
    RigidWall wall(card);
    const std::vector<double> mass{2.0};
    const Vec3 downhill(-std::cos(angle), 0.0, -std::sin(angle));
    Points x{Vec3::Zero()}, v{Vec3::Zero()};
    constexpr int STEPS = 500;
    for (int n = 0; n < STEPS; ++n) {
        v[0] -= STEP * G * Vec3::UnitZ();
        wall.hold(x, mass, n * STEP, STEP, v);
        x[0] += STEP * v[0];
    }
    const double slide = std::max(0.0, std::sin(angle) - mu * std::cos(angle));
    CHECK(v[0].dot(downhill) / (STEPS * STEP) == Approx(G * slide).epsilon(1e-10).margin(1e-12));
    CHECK(std::abs(x[0].dot(std::get<HalfSpace>(card.shape).normal)) < 1e-13);
    const double weight = 2.0 * G * std::cos(angle);  // what the plane bears
    CHECK(-wall.force().dot(std::get<HalfSpace>(card.shape).normal) ==
          Approx(weight).epsilon(1e-9));
}

TEST_CASE("a plate stops what comes through its front, however fast, and lets its back pass",
          "[contact]") {
    WallCard card;
    card.shape = Plate{Vec3::Zero(), Mat3::Identity(), {0.0, 0.0}, {1.0, 2.0}};
    card.nodes = {0, 1, 2, 3};
    RigidWall wall(card);
    const std::vector<double> mass(4, 1.0);
    constexpr double STEP = 1.0;
    // onto it at a slant; past it; from below; down beside it and then under it
    Points x{{-1.0, 1.0, 1.5}, {0.5, 1.0, 0.1}, {0.5, 0.5, -1.0}, {-0.5, 1.0, 0.5}};
    Points v{{2.0, 0.0, -2.0}, {3.0, 0.0, -0.2}, {0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}};
    const Points before = v;
    wall.hold(x, mass, 0.0, STEP, v);
    CHECK((v[0] - Vec3(2.0, 0.0, -1.5)).norm() < 1e-15);
    for (std::size_t i : {1, 2, 3}) CHECK(v[i] == before[i]);
    for (std::size_t i = 0; i < 4; ++i) x[i] += STEP * v[i];

    v[3] = Vec3(1.0, 0.0, 0.0);   // under the plate
    v[2] = Vec3(0.0, 0.0, -9.0);  // has come out in front: back down it is stopped
    x[0].z() = -1e-3;             // something else has pushed it through the plate
    wall.hold(x, mass, STEP, STEP, v);
    CHECK(v[3] == Vec3(1.0, 0.0, 0.0));
    CHECK(v[2].z() == Approx(-4.0));
    CHECK(v[0].z() == Approx(1e-3));  // back to where it was held
    x[3] += STEP * v[3];
    v[3] = Vec3(0.0, 0.0, 9.0);  // and up through it
    wall.hold(x, mass, 2.0 * STEP, STEP, v);
    CHECK(v[3] == Vec3(0.0, 0.0, 9.0));
}

TEST_CASE("no node of a cloud ever gets into a shape, and none jumps through it", "[contact]") {
    WallCard card;
    const int kind = GENERATE(0, 1, 2);
    const Vec3 axis = Vec3(1, 2, 3).normalized();
    if (kind == 0) card.shape = Ball{Vec3(0.1, 0, 0), 0.05};
    if (kind == 1) card.shape = Rod{Vec3::Zero(), axis, 0.04, -0.05, 0.1};
    if (kind == 2) {
        Brick block;
        block.axes = Eigen::AngleAxisd(0.7, axis).toRotationMatrix();
        block.low = Vec3(-0.1, -0.02, -0.05);
        block.high = Vec3(0.05, 0.02, 0.0);
        card.shape = block;
    }
    std::mt19937 random(7);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    Points x, v;
    std::vector<double> mass;
    while (x.size() < 2000) {
        const Vec3 at(u(random), u(random), u(random));
        if (nearest(card.shape, at).gap < 0.0) continue;
        card.nodes.push_back(static_cast<Index>(x.size()));
        x.push_back(at);
        // at the shape, more or less: most would jump through in the first step
        v.push_back((-at + 0.1 * Vec3(u(random), u(random), u(random))) * 2.0);
        mass.push_back(1.0 + u(random) * 0.5);
    }
    RigidWall wall(card);
    const double start = [&] {
        double sum = 0.0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += 0.5 * mass[i] * v[i].squaredNorm();
        return sum;
    }();
    std::size_t stopped = 0;
    for (int n = 0; n < 5; ++n) {
        const Points free = v;
        wall.hold(x, mass, n * 1.0, 1.0, v);
        stopped += wall.touching().size();
        Vec3 taken = Vec3::Zero();
        for (std::size_t i = 0; i < x.size(); ++i) {
            taken += mass[i] * (free[i] - v[i]);
            for (int k = 1; k <= 20; ++k)  // along the whole way
                REQUIRE(nearest(card.shape, x[i] + k / 20.0 * v[i]).gap > -1e-12);
            x[i] += v[i];
        }
        CHECK((taken - wall.force()).norm() < 1e-9);
    }
    CHECK(stopped > 100);
    double left = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) left += 0.5 * mass[i] * v[i].squaredNorm();
    CHECK(start - left == Approx(wall.stopping_energy()).epsilon(1e-10));
}
