// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what loads, weighs and damps nodes acts, and meshes as others make them are bags
// (tests/decks).

#include <catch2/catch.hpp>

#include <cmath>

#include "tests/support/decks/stepped_deck.hpp"

using namespace corpuscle;

TEST_CASE("forces on nodes, added masses, damping of a part, and what cannot matter is read over",
          "[io]") {
    Run run("loads_of_nodes.k");
    run.steps(20);
    const double t = run.half_step;
    CHECK(run.v(5).x() == Approx(0.1 * 20.0 / 0.01 * t).epsilon(1e-9));
    for (const int node : {6, 7})
        CHECK(run.v(node).y() == Approx(-0.1 * 10.0 / 0.02 * t).epsilon(1e-9));
    // v exp(-d t) at steps of dt, to first order in d dt
    const double d = 50.0, dt = run.scene.time() / 20.0;
    for (int node = 1; node <= 4; ++node)
        CHECK(run.v(node).z() == Approx(10.0 * std::exp(-d * t)).epsilon(d * dt));
    CHECK(run.v(1).z() < 10.0 * (1.0 - 0.9 * d * t));
    CHECK(run.residual < 1e-9 * run.moved);
    CHECK(tells(run.scene.model().warnings, "it goes on to ENDTIM"));
    CHECK(tells(run.scene.model().warnings, "stiffness damping is not acted on"));
}

TEST_CASE("forces and moments on rigid bodies act as Newton and Euler say, and bring their work",
          "[io]") {
    Run run("rigid_loads.k");
    constexpr double MASS = 0.08, FORCE = 4.0, WIDTH = 0.2, DEPTH = 0.1, SPIN = 40.0;
    constexpr double MOMENT = 0.02, ABOUT_Z = MASS / 4.0 * (WIDTH * WIDTH + DEPTH * DEPTH);
    run.to_the_end();
    const auto& bodies = run.scene.bodies();
    REQUIRE(bodies.size() == 5);
    REQUIRE(bodies[0].mass() == Approx(MASS).epsilon(1e-12));
    const double t = run.half_step, end = run.scene.time();
    // x = F t^2 / 2 m, of corners too; L = M t
    CHECK(run.x(11).x() + 0.1 == Approx(FORCE * end * end / (2.0 * MASS)).epsilon(1e-10));
    CHECK((bodies[1].spin() - MOMENT / ABOUT_Z * t * Vec3::UnitZ()).norm() < 1e-12 * SPIN);
    CHECK(bodies[1].velocity().norm() == 0.0);
    // along the normal of a plate that turns about y: v = F / (m w) (1 - cos w t, 0, sin w t)
    const Vec3 followed(1.0 - std::cos(SPIN * t), 0.0, std::sin(SPIN * t));
    for (const std::size_t b : {2U, 3U}) {
        CHECK((bodies[b].velocity() - FORCE / (MASS * SPIN) * followed).norm() < 1e-5);
        CHECK((bodies[b].velocity() - bodies[2].velocity()).norm() < 1e-14);
    }
    CHECK((bodies[4].velocity() - FORCE / MASS * t * Vec3::UnitY()).norm() < 1e-12);
    CHECK((bodies[4].angular_momentum() - 0.01 * t * Vec3::UnitY()).norm() < 1e-14);
    CHECK(run.residual < 1e-12 * run.moved);
}

TEST_CASE(
    "parts that are rigid from the start have the mass of their material, and their nodes' own",
    "[io]") {
    Run run("stiffened.k");
    constexpr double PLATE = 0.08, NODE = 0.02, FORCE = 4.0, MOMENT = 0.02;
    // of the plate, by the shift of its centre, of the node, and what the node has itself
    constexpr double ABOUT_Z =
        PLATE / 4.0 * 0.05 + PLATE * 5e-4 + NODE * (0.08 * 0.08 + 0.04 * 0.04) + 5e-4;
    run.to_the_end();
    const auto& bodies = run.scene.bodies();
    REQUIRE(bodies.size() == 2);
    const double t = run.half_step;
    CHECK(run.scene.active_shells() == 0);
    CHECK((bodies[0].velocity() - FORCE / (PLATE + NODE) * t * Vec3::UnitX()).norm() < 1e-12);
    CHECK(bodies[0].spin().z() == Approx(MOMENT / ABOUT_Z * t).epsilon(1e-12));
    CHECK((bodies[1].velocity() - FORCE / (2.0 * PLATE) * t * Vec3::UnitY()).norm() < 1e-12);
    CHECK(run.residual < 1e-12 * run.moved);
}

TEST_CASE("a flat bag of quads closes, also where both panels' corners lie between the same nodes",
          "[io]") {
    Run run("flat_corners.k");
    // 4 x 4 cells of 20 mm, inner nodes 5 mm up or down: cells inside, at sides, in corners
    const double cell = 0.02 * 0.02 * 0.005;
    const double volume = 2.0 * cell * (4.0 + 8.0 / 2.0 + 4.0 / 3.0);
    const double other_cut = 2.0 * cell * (4.0 + 8.0 / 2.0 + 2.0 / 3.0 + 2.0 / 6.0);
    CHECK(run.scene.uniform_bags().at(0).gas().mass() == Approx(1.2 * volume).epsilon(1e-12));
    CHECK(other_cut == Approx(27.0 / 28.0 * volume));  // so the mass tells them apart
    run.steps(20);
}

TEST_CASE("time of a motion's curve counts from its birth on, along the axes of a local system",
          "[io]") {
    constexpr double BIRTH = 0.02, RATE = 4.0, SIDE = 0.1;
    Run run("late_motions.k");
    double start = 0.0;  // of the first step that moves
    while (!run.scene.is_over()) {
        run.steps(1);
        if (start == 0.0 && run.last_time >= BIRTH) start = run.last_time;
    }
    const double end = run.scene.time(), late = end - BIRTH, missed = start - BIRTH;
    REQUIRE(missed < 1e-2 * late);
    const double led = 0.5 * RATE * (late * late - missed * missed);
    CHECK(run.x(11).x() + SIDE == Approx(led).epsilon(1e-9));
    CHECK(run.x(11).y() + 0.05 == Approx(0.5 * RATE * end * end).epsilon(1e-6));
    CHECK(run.x(21).x() + SIDE == Approx(RATE * (end - start)).epsilon(1e-9));
    CHECK(run.x(31).x() + SIDE == Approx(RATE / 6.0 * std::pow(late, 3.0)).epsilon(5e-3));
    CHECK(run.x(41).y() - 2.95 == Approx(led).epsilon(1e-9));
    CHECK(run.x(41).x() == Approx(-SIDE).epsilon(1e-12));
    const Vec3 spin = run.scene.bodies()[4].spin();
    CHECK(spin.x() == Approx(-RATE * (run.half_step - BIRTH)).epsilon(1e-9));
    CHECK(spin.tail<2>().norm() < 1e-12);
    for (const int node : {61, 64}) CHECK(-run.x(node).x() - SIDE == Approx(led).epsilon(1e-9));
    CHECK(run.x(61).z() == Approx(0.1 * (end - start)).epsilon(1e-9));
    CHECK(tells(run.scene.model().warnings, "does not count for a *DEFINE_CURVE_FUNCTION"));
}
