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
