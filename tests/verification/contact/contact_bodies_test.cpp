// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: rigid bodies and fabric feel each other in contact, with friction, exact in momentum and
// closed in energy, and nothing crosses.

#include <catch2/catch.hpp>

#include "tests/support/geometry/cloth.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

using scenes::add;
using scenes::pull;
using scenes::rigid;
using scenes::run;
using scenes::totals;
using scenes::Totals;
using scenes::touch;

namespace {

constexpr double GRAVITY = 9.81;

}  // namespace

TEST_CASE("a spinning ball hits free cloth: momentum, angular momentum and energy are kept",
          "[contact][rigid]") {
    Model model = scenes::empty(4e-3);
    const support::Sheet sheet = support::square_sheet(12, 0.2);
    add(model, sheet.x, sheet.triangles, scenes::cloth(), 3e-4, Vec3(-0.1, -0.1, 0));
    const Index ball =
        add(model, shapes::sphere(0.04, 3), rigid(200.0), 2e-3, Vec3(0.011, 0.007, 0.045));
    model.rigid_velocity = {{ball, Vec3(2, 1, -15), Vec3(30, -80, 120)}};
    contact::ContactCard card;
    card.friction_static = card.friction_dynamic = 0.3;
    touch(model, card);
    Simulation simulation(model);
    const Totals before = totals(simulation);
    const EnergyBooks books = run(simulation);
    const Totals after = totals(simulation);
    const double scale = before.momentum.norm();
    CHECK((after.momentum - before.momentum).norm() < 1e-9 * scale);
    CHECK(after.momentum.z() != Approx(simulation.bodies()[0].mass() *
                                       simulation.bodies()[0].velocity().z()));  // they did meet
    CHECK(std::abs(books.residual) < 0.01 * before.kinetic);
    CHECK(books.friction > 0.0);
    CHECK(simulation.contact()->counts().unstopped == 0);
}

TEST_CASE("two rigid boxes that meet keep momentum and angular momentum", "[contact][rigid]") {
    Model model = scenes::empty(10e-3);
    const Index a =
        add(model, shapes::box(Vec3(0.1, 0.1, 0.1), 2), rigid(1000.0), 1e-3, Vec3::Zero());
    const Index b = add(model, shapes::box(Vec3(0.08, 0.05, 0.06), 2), rigid(3000.0), 1e-3,
                        Vec3(0.11, 0.03, 0.05));
    model.rigid_velocity = {{a, Vec3(5, 0, 0), Vec3(0, 0, 20)}, {b, Vec3(-5, 1, 0), Vec3::Zero()}};
    touch(model);
    model.contacts[0].damping = 0.0;
    Simulation simulation(model);
    const Totals before = totals(simulation);
    const EnergyBooks books = run(simulation);
    const Totals after = totals(simulation);
    CHECK((after.momentum - before.momentum).norm() < 1e-12 * simulation.bodies()[1].mass() * 5.0);
    CHECK(simulation.contact()->counts().impacts == 0);
    CHECK((after.turning - before.turning).norm() < 1e-9 * before.turning.norm());
    CHECK(simulation.bodies()[0].velocity().x() < 4.0);
    CHECK(std::abs(books.residual) < 0.01 * before.kinetic);
}

TEST_CASE("a block on an incline sticks below the friction angle and slides above it",
          "[contact][rigid][friction]") {
    const double mu = 0.3;
    const auto slid = [&](double angle, double time) {
        Model model = scenes::empty(time);
        const support::Sheet floor = support::square_sheet(4, 0.6);
        const Index plate =
            add(model, floor.x, floor.triangles, rigid(1000.0), 1e-3, Vec3(-0.3, -0.3, 0));
        std::get<fabric::RigidCard>(model.materials[plate].card).fixed_moves = 7;
        std::get<fabric::RigidCard>(model.materials[plate].card).fixed_turns = 7;
        const Index block = add(model, shapes::box(Vec3(0.1, 0.08, 0.03), 2), rigid(1000.0), 1e-3,
                                Vec3(0, 0, 1.0005e-3));
        pull(model, GRAVITY * Vec3(std::sin(angle), 0, -std::cos(angle)));
        contact::ContactCard card;
        card.kind = contact::ContactCard::Kind::SURFACE_TO_SURFACE;
        card.friction_static = card.friction_dynamic = mu;
        card.id = 1;
        card.parts = {block};
        card.other_parts = {plate};
        model.contacts = {card};
        Simulation simulation(model);
        double at_half = 0.0;
        const double start = simulation.bodies()[1].position().x();
        run(simulation, [&](Simulation& s) {
            if (s.time() <= 0.5 * time) at_half = s.bodies()[1].position().x() - start;
        });
        return std::pair(at_half, simulation.bodies()[1].position().x() - start);
    };
    const double friction_angle = std::atan(mu), time = 0.1;
    const auto [stick_half, stick] = slid(friction_angle - 0.02, time);
    INFO("settled by " << stick_half << " then moved " << stick - stick_half);
    CHECK(std::abs(stick_half) < 1e-4);
    CHECK(std::abs(stick - stick_half) < 1e-6);
    const double angle = friction_angle + 0.1;
    const double wanted = GRAVITY * (std::sin(angle) - mu * std::cos(angle));
    const auto [half, whole] = slid(angle, time);
    // two points of the parabola: free of what the first contact does
    const double acceleration = (whole - 2.0 * half) / (0.25 * time * time);
    INFO("slid " << half << " " << whole << " wanted " << 0.5 * wanted * time * time);
    CHECK(acceleration == Approx(wanted).epsilon(0.01));
}
