// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include "gas/thermo/orifice_flow.hpp"
#include "tests/support/decks/stepped_deck.hpp"
#include "tests/verification/decks/decks_setup.hpp"

using namespace corpuscle;
using namespace decks_setup;

TEST_CASE("an adiabatic bag keeps p V^gamma", "[io]") {
    Run run("adiabatic.k");
    const gas::ControlVolume& gas = run.scene.uniform_bags().at(0).gas();
    CHECK(gas.pressure() == Approx(151325.0).epsilon(1e-12));
    CHECK(gas.mass() == Approx(1.8 * VOLUME).epsilon(1e-12));
    run.to_the_end();
    CHECK(gas.volume() > 1.05 * VOLUME);
    CHECK(gas.pressure() == Approx(151325.0 * std::pow(VOLUME / gas.volume(), 1.4)).epsilon(2e-3));
}

TEST_CASE("a pressure over time swells the bag, whichever way its normals point", "[io]") {
    Model model = read("load_curve.k");
    REQUIRE(model.pressure_loads.size() == 1);
    Run run(model);
    run.to_the_end();
    CHECK(run.x(25).z() < -0.001);  // the middles of the lower and the upper face
    CHECK(run.x(26).z() > 0.101);
}

TEST_CASE("cloth that is tied to a rigid part rides on it, with smooth curves, boxes, common sets",
          "[io]") {
    Run run("tied_contact.k");
    const Model& model = run.scene.model();
    CHECK(model.history_nodes == std::vector<Index>{2, 3});
    CHECK(model.contact_shells.at(0).first.size() == 4);  // those of the upper face
    CHECK(tells(model.warnings, "ties 9 nodes rigidly"));
    run.to_the_end();
    CHECK(run.x(31).z() == Approx(-0.0001 + 0.003).epsilon(1e-3));
    for (const int node : {1, 2, 7, 10, 16, 20, 23, 25})
        CHECK(run.x(node).z() == Approx(run.x(31).z() + 0.0001).epsilon(1e-9));
}
