// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: cloth that falls on a ball, on a box's edge or on itself crosses nothing, counted exactly;
// momentum and energy are kept.

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/geometry/cloth.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;
using scenes::add;

namespace {

constexpr double SIDE = 0.5;  ///< of the cloth [m]

/// Cloth of 2 n² facets over the origin that falls at a speed.
Model falling_cloth(Index n, double speed, double end_time) {
    Model model = scenes::empty(end_time);
    const support::Sheet sheet = support::square_sheet(n, SIDE);
    add(model, sheet.x, sheet.triangles, scenes::cloth(), 3e-4, {-0.51 * SIDE, -0.48 * SIDE, 0.0});
    model.velocity.assign(model.x.size(), Vec3(0, 0, -speed));
    return model;
}

/// Runs it and holds it to the claim.
void hold_to_claim(Model& model) {
    contact::ContactCard card;
    card.friction_static = card.friction_dynamic = 0.2;
    scenes::touch(model, card);
    Simulation simulation(model);
    const scenes::Totals before = scenes::totals(simulation);
    double kinetic = before.kinetic, scale = 0.0;
    for (std::size_t i = 0; i < simulation.nodes().size(); ++i) {
        const Vec3& v = simulation.nodes().v[i];
        kinetic += 0.5 * simulation.nodes().mass[i] * v.squaredNorm();
        scale += simulation.nodes().mass[i] * v.norm();
    }
    const contact::ContactCounts& counts = simulation.contact()->counts();
    std::size_t most_near = 0;
    const auto watch = [&](Simulation&) { most_near = std::max(most_near, counts.near); };
    const EnergyBooks books = scenes::run(simulation, watch, 5);
    INFO(simulation.steps() << " steps, " << counts.builds << " builds, " << most_near << " near, "
                            << counts.impacts << " impacts, residual " << books.residual / kinetic);
    CHECK(counts.unstopped == 0);
    CHECK(most_near > 100);
    CHECK((scenes::totals(simulation).momentum - before.momentum).norm() < 1e-9 * scale);
    CHECK(std::abs(books.residual) < 0.01 * kinetic);
}

void drop_on_ball(Index n) {
    Model model = falling_cloth(n, 20.0, 8e-3);
    add(model, shapes::sphere(0.1, 4), scenes::rigid(4000.0), 2e-3, {0, 0, -0.104});
    hold_to_claim(model);
}

void drop_on_edge(Index n) {
    Model model = falling_cloth(n, 20.0, 8e-3);
    shapes::Shape box = shapes::box({0.2, 0.3, 0.2}, 4);
    for (Vec3& x : box.x)
        x = Eigen::AngleAxisd(0.25 * M_PI, Vec3::UnitY()) * Vec3(x - Vec3(0.1, 0.15, 0.1));
    add(model, box, scenes::rigid(4000.0), 2e-3, {0, 0, -0.146});
    hold_to_claim(model);
}

/// Cloth bent back over itself, 10 mm above; that half falls and is drawn together.
void drop_on_itself(Index n) {
    constexpr double HEIGHT = 10e-3, FLAT = 0.5 * (SIDE - 0.5 * M_PI * HEIGHT);
    Model model = falling_cloth(n, 0.0, 5e-3);
    for (std::size_t i = 0; i < model.x.size(); ++i) {
        Vec3& x = model.x[i];
        const double s = x.x() + 0.51 * SIDE;
        const double angle = std::clamp((s - FLAT) / (0.5 * HEIGHT), 0.0, M_PI);
        const double share = angle / M_PI;
        const double way = s < FLAT ? s : s > SIDE - FLAT ? SIDE - s : FLAT;
        x = {way + 0.5 * HEIGHT * std::sin(angle), x.y(), 0.5 * HEIGHT * (1.0 - std::cos(angle))};
        model.velocity[i] = share * Vec3(-60.0 * (x.x() - 0.1), -60.0 * x.y(),
                                         -30.0 - 8.0 * std::sin(60.0 * x.x() + 90.0 * x.y()));
    }
    hold_to_claim(model);
}

}  // namespace

TEST_CASE("5 000 facets that fall on a ball cross nothing", "[contact][rigid]") {
    drop_on_ball(50);
}
TEST_CASE("5 000 facets that fall on a box's edge cross nothing", "[contact][rigid]") {
    drop_on_edge(50);
}
TEST_CASE("5 000 facets that fall on themselves cross nothing", "[contact]") {
    drop_on_itself(50);
}
TEST_CASE("20 000 facets that fall cross nothing", "[.long][contact][rigid]") {
    SECTION("on a ball") {
        drop_on_ball(100);
    }
    SECTION("on a box's edge") {
        drop_on_edge(100);
    }
    SECTION("on themselves") {
        drop_on_itself(100);
    }
}
