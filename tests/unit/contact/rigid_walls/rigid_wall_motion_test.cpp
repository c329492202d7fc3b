// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "contact/rigid_walls/rigid_wall.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

WallCard ball_card(std::size_t nodes) {
    WallCard card;
    card.shape = Ball{Vec3::Zero(), 0.1};
    for (std::size_t i = 0; i < nodes; ++i) card.nodes.push_back(static_cast<Index>(i));
    return card;
}

}  // namespace

TEST_CASE("a wall goes exactly the way that its curve gives", "[contact]") {
    const Curve speed{1, {0.0, 1e-3, 3e-3}, {0.0, 10.0, -4.0}};
    const Curve way{2, {0.0, 1e-3, 3e-3}, {2e-3, 10e-3, -4e-3}};
    const double birth = GENERATE(0.0, 0.35e-3);
    WallCard card = ball_card(0);
    card.birth = birth;
    card.motion.direction = Vec3(2, -1, 2) / 3.0;
    card.motion.curve = 0;
    RigidWall by_speed(card, &speed);
    card.motion.is_displacement = true;
    RigidWall by_way(card, &way);
    Points none;
    const std::vector<double> mass;
    double t = 0.0, dt_last = 0.0;
    int looks = 0;
    for (int n = 0; n < 50; ++n) {
        const double dt = 1e-4 * (1.0 + 0.5 * std::sin(n));
        by_speed.hold(none, mass, t, dt, none);
        by_way.hold(none, mass, t, dt, none);
        const double since = std::max(0.0, t - birth);
        const double end = std::min(since, 3e-3);
        const double gone = since > 0.0 ? speed.mean(0.0, end) * end - 4.0 * (since - end) : 0.0;
        CHECK((by_speed.displacement() - gone * card.motion.direction).norm() < 1e-15);
        CHECK((by_way.displacement() - way(since) * card.motion.direction).norm() < 1e-15);
        // linear between the middles of the steps: exact at t, where no knot is near
        if (const double knot = birth + 1e-3;
            t == 0.0 || (t - dt_last > birth && (t + dt < knot || t - dt_last > knot) &&
                         t + dt < birth + 3e-3)) {
            const double weight = t == 0.0 ? 1.0 : dt_last / (dt_last + dt);
            const double at_t = birth > 0.0 && t == 0.0 ? 0.0
                                : t == 0.0              ? speed(0.5 * dt)
                                                        : speed(t - birth);
            CHECK((by_speed.velocity_at_t(weight) - at_t * card.motion.direction).norm() < 1e-12);
            ++looks;
        }
        t += dt;
        dt_last = dt;
    }
    CHECK(looks > 15);
}

TEST_CASE("a wall at a constant speed starts at its birth, and its mass is then given energy",
          "[contact]") {
    const double mass = GENERATE(0.0, 3.0);
    WallCard card = ball_card(1);
    card.birth = 0.35e-3;
    card.motion = {Vec3::UnitX(), -1, false, 5.0, mass};
    RigidWall wall(card);
    const Points x{Vec3(1.0, 0.0, 0.0)};  // far away
    Points v{Vec3::Zero()};
    constexpr double DT = 1e-4;
    for (int n = 0; n < 20; ++n) {
        const double t = n * DT;
        wall.hold(x, {&mass, 1}, t, DT, v);
        const double gone = 5.0 * std::max(0.0, t - card.birth);
        CHECK(wall.displacement().x() == Approx(gone).margin(1e-15));
        CHECK(wall.velocity().x() == Approx(n < 3 ? 0.0 : n == 3 ? 2.5 : 5.0).margin(1e-12));
        CHECK(wall.driving_work() == Approx(wall.kinetic_energy()).margin(1e-15));
    }
    CHECK(wall.kinetic_energy() == 0.5 * mass * 25.0);
}

TEST_CASE("a wall of mass is slowed down by what it hits: plastic impacts", "[contact]") {
    const Vec3 n = Vec3(1, 2, -2) / 3.0;
    const bool is_plate = GENERATE(false, true);
    WallCard card;
    card.shape = HalfSpace{Vec3::Zero(), n};
    if (is_plate) {
        Plate plate;
        plate.axes << n.unitOrthogonal(), n.cross(n.unitOrthogonal()), n;
        plate.low[0] = plate.low[1] = -1.0;
        plate.high[0] = plate.high[1] = 1.0;
        card.shape = plate;
    }
    card.nodes = {0, 1, 2};
    card.motion = {n, -1, false, 8.0, 3.0};
    RigidWall wall(card);
    // one in its way, one further ahead, one that comes towards it
    const std::vector<double> mass{2.0, 1.0, 0.5};
    Points x{0.1 * n, 0.5 * n, 1.1 * n}, v{Vec3::Zero(), Vec3::Zero(), -5.0 * n};
    constexpr double DT = 1e-3;
    const auto momentum = [&] {
        double p = 3.0 * wall.velocity().dot(n);
        for (std::size_t i = 0; i < 3; ++i) p += mass[i] * v[i].dot(n);
        return p;
    };
    const auto energy = [&] {
        double e = wall.kinetic_energy();
        for (std::size_t i = 0; i < 3; ++i) e += 0.5 * mass[i] * v[i].squaredNorm();
        return e;
    };
    const double p = momentum(), e = energy();
    for (int step = 0; step < 400; ++step) {
        wall.hold(x, mass, step * DT, DT, v);
        REQUIRE(momentum() == Approx(p).epsilon(1e-12));
        REQUIRE(energy() + wall.stopping_energy() == Approx(e).epsilon(1e-12));
        for (std::size_t i = 0; i < 3; ++i) {
            x[i] += DT * v[i];
            REQUIRE(n.dot(x[i] - wall.displacement() - DT * wall.velocity()) > -1e-12);
        }
    }
    // impact after impact: what was hit before flies ahead of the wall, which gets slower
    const double first = 3.0 * 8.0 / 5.0, second = 3.0 * first / 4.0;
    const double third = (3.0 * second - 0.5 * 5.0) / 3.5;
    CHECK((v[0] - first * n).norm() < 1e-12);
    CHECK((v[1] - second * n).norm() < 1e-12);
    CHECK((v[2] - third * n).norm() < 1e-12);
    CHECK((wall.velocity() - third * n).norm() < 1e-12);
    CHECK(wall.driving_work() == 0.0);
}

TEST_CASE("a driven wall carries a node along, and its work is booked", "[contact]") {
    WallCard card = ball_card(1);
    const Curve speed{1, {0.0, 1.0}, {5.0, 25.0}};
    card.motion.direction = Vec3::UnitX();
    card.motion.curve = 0;
    RigidWall wall(card, &speed);
    const std::vector<double> mass{0.2};
    Points x{Vec3(0.15, 0, 0)}, v{Vec3::Zero()};
    constexpr double DT = 1e-3;
    for (int n = 0; n < 100; ++n) {
        wall.hold(x, mass, n * DT, DT, v);
        x[0] += DT * v[0];
    }
    CHECK(v[0].x() == Approx(speed(0.0995)).epsilon(1e-12));
    CHECK(x[0].x() == Approx(0.1 + speed.mean(0.0, 0.1) * 0.1).epsilon(1e-12));
    CHECK(wall.driving_work() ==
          Approx(0.1 * v[0].squaredNorm() + wall.stopping_energy()).epsilon(1e-12));
    CHECK(wall.stopping_energy() > 0.0);
    CHECK(wall.kinetic_energy() == 0.0);
}

TEST_CASE("what a wall does is the same seen from a train", "[contact]") {
    const Vec3 train(300.0, -40.0, 7.0);
    WallCard card = ball_card(1);
    card.friction = 0.3;
    RigidWall fixed(card);
    card.motion.direction = train.normalized();
    card.motion.speed = train.norm();
    RigidWall moving(card);
    const std::vector<double> mass{2.0};
    const Points x{Vec3(0.08, 0.0, 0.1)};
    Points v{Vec3(0.0, 1.0, -50.0)}, seen{v[0] + train};
    fixed.hold(x, mass, 0.0, 1e-2, v);
    moving.hold(x, mass, 0.0, 1e-2, seen);
    REQUIRE(fixed.touching().size() == 1);
    CHECK((seen[0] - train - v[0]).norm() < 1e-10);
    CHECK((moving.force() - fixed.force()).norm() < 1e-6);
    CHECK(moving.stopping_energy() == Approx(fixed.stopping_energy()));
    CHECK(moving.friction_energy() == Approx(fixed.friction_energy()));
    CHECK(fixed.friction_energy() > 0.0);
}
