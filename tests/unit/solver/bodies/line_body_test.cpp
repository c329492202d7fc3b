// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "solver/bodies/free_rotation.hpp"
#include "solver/bodies/rigid_body.hpp"

using namespace corpuscle;

namespace {

const Vec3 ALONG = Vec3(0.3, -0.7, 0.6458).normalized(),
           ACROSS = ALONG.cross(Vec3::UnitX()).normalized();

/// Four equal masses on an oblique line, the third of them off it.
struct Rod {
    static constexpr double MASS = 0.5, STEP = 1e-5;
    fabric::Nodes nodes;
    RigidBody body;

    Rod(double off, const Vec3& spin) : Rod(model(off, spin)) {}
    void step(int count) {
        for (int k = 0; k < count; ++k) {
            body.advance(k * STEP, STEP, STEP, {}, nodes);
            nodes.drift(STEP);
            nodes.x.swap(nodes.x_1);
        }
    }
    [[nodiscard]] Vec3 reach() const { return nodes.x[1] - nodes.x[0]; }

private:
    explicit Rod(const Model& of)
        : nodes{of.x, of.x, of.velocity, Points(4, Vec3::Zero()), std::vector<double>(4, MASS)},
          body(of, 0, std::vector<double>(4, MASS)) {}

    static Model model(double off, const Vec3& spin) {
        Model out;
        out.x = {Vec3(1, 2, 3) - 0.1 * ALONG, Vec3(1, 2, 3) + 0.1 * ALONG,
                 Vec3(1, 2, 3) + 0.03 * ALONG + off * ACROSS, Vec3(1, 2, 3) - 0.05 * ALONG};
        out.velocity.assign(4, Vec3::Zero());
        out.node_id = {1, 2, 3, 4};
        out.shells = {{1, 0, {0, 2, 1, 3}}};
        out.parts.resize(1);
        out.parts[0].id = 7;
        out.parts[0].material = 0;
        fabric::RigidCard card;
        card.density = 1000;
        out.materials = {{1, "", card}};
        out.rigid_velocity = {{0, Vec3::Zero(), spin}};
        out.end_time = 1.0;
        return out;
    }
};

}  // namespace

TEST_CASE("a straight row of masses turns about its centre as a rod does", "[solver][rigid]") {
    Rod rod(0.0, 125.0 * ACROSS);
    const Vec3 first = rod.reach();
    const double energy = rod.body.kinetic_energy();
    CHECK(energy > 0.0);
    rod.step(2000);
    // the midpoint rule's angle of a step
    const double angle = 2000 * 2.0 * std::atan(0.5 * Rod::STEP * 125.0);
    const Vec3 then = std::cos(angle) * first + std::sin(angle) * ACROSS.cross(first);
    CHECK((rod.reach() - then).norm() < 1e-11 * first.norm());
    CHECK(rod.body.kinetic_energy() == Approx(energy).epsilon(1e-12));
}

TEST_CASE("a row that is nearly straight keeps its energy at any spin", "[solver][rigid]") {
    const double off = GENERATE(1e-12, 1e-7, 1e-6, 4e-6, 1e-5, 1e-4, 1e-2);
    Rod rod(off, Vec3(40.0, 80.0, -90.0));
    const double energy = rod.body.kinetic_energy();
    const Vec3 momentum = rod.body.angular_momentum();
    rod.step(500);
    CHECK(rod.body.kinetic_energy() == Approx(energy).epsilon(1e-8));
    CHECK((rod.body.angular_momentum() - momentum).norm() < 1e-9 * momentum.norm());
}

TEST_CASE("nothing turns a straight row about itself, a couple across it does", "[solver][rigid]") {
    Rod rod(0.0, Vec3::Zero());
    RigidBody::Field field;
    field.moment = 3.0 * ALONG + 2.0 * ACROSS;
    rod.body.advance(0.0, Rod::STEP, Rod::STEP, field, rod.nodes);
    CHECK((rod.body.angular_momentum() - 2.0 * Rod::STEP * ACROSS).norm() < 1e-18);
    CHECK(std::abs(rod.body.spin().dot(ALONG)) < 1e-12 * rod.body.spin().norm());
    CHECK(rod.body.field_work() == Approx(rod.body.kinetic_energy()).epsilon(1e-9));
}

TEST_CASE("a turn in parts is the turn of as many steps", "[solver][rigid]") {
    const Vec3 moments(1e-8, 1.0, 1.1), momentum(2e-6, 60.0, 80.0);
    constexpr double DT = 1e-3;
    const auto whole = free_turn(moments, momentum, DT);
    REQUIRE(whole);
    Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
    constexpr int PARTS = 4096;
    for (int k = 0; k < PARTS; ++k) {
        const auto step = free_turn(moments, turn.conjugate() * momentum, DT / PARTS);
        REQUIRE(step);
        turn = (turn * *step).normalized();
    }
    const auto energy = [&](const Eigen::Quaterniond& at) {
        const Vec3 local = at.conjugate() * momentum;
        return 0.5 * local.dot(spin_by(moments, local));
    };
    CHECK(energy(*whole) == Approx(energy(Eigen::Quaterniond::Identity())).epsilon(1e-9));
    CHECK(energy(turn) == Approx(energy(Eigen::Quaterniond::Identity())).epsilon(1e-9));
    const Vec3 axis = Vec3::UnitX();  // of the least moment, about which it spins on its own
    CHECK((turn * axis - axis).norm() > 0.09);
    CHECK((turn * axis - *whole * axis).norm() < 1e-3);
}
