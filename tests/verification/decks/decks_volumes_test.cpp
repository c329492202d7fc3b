// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: control volumes of others' decks mean what their authors meant (tests/decks).

#include <catch2/catch.hpp>

#include <cmath>

#include "gas/thermo/orifice_flow.hpp"
#include "tests/support/decks/stepped_deck.hpp"
#include "tests/verification/decks/decks_setup.hpp"

using namespace corpuscle;
using namespace decks_setup;

namespace {

/// A mass flow that ends at equal pressures.                                             [kg]
double exchanged(double rate, double dt, double p, double p_to, double T) {
    const double equal = (p - p_to) / (CP / CV * R * T * (2.0 / VOLUME));
    return equal * -std::expm1(-rate * dt / equal);
}

/// The books' error is one of integration: second order in the step.
double residual_of_half_the_step(Model model) {
    model.step_factor *= 0.5;
    Run run(std::move(model));
    run.to_the_end();
    return run.residual;
}

}  // namespace

TEST_CASE("jets do not act, and are said not to, and the cards behind them are read", "[io]") {
    for (const char* deck : {"wang_nefske_jetting.k", "wang_nefske_jetting_molar.k"}) {
        CAPTURE(deck);
        Run run(deck);
        const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
        CHECK(bag.gas().mass() == Approx(RO * VOLUME).epsilon(1e-12));
        CHECK(tells(run.scene.model().warnings, "has jets, which do not act"));
        CHECK_FALSE(tells(run.scene.model().warnings, "inflator card"));
        run.steps(5);
        CHECK(bag.mass_in() == Approx(0.1 * run.scene.time()).epsilon(1e-12));
    }
    CHECK(Run("wang_nefske_jetting_molar.k").scene.uniform_bags().at(0).card().cp ==
          Approx((26.0 + 0.01 * 300.0) / 0.028).epsilon(1e-12));
}

TEST_CASE("two bags that vent into each other keep mass and come to one pressure", "[io]") {
    const double p = PE + POVER, T = p / (RO * R);
    const double rate = 0.6 * 0.005 * gas::orifice_flow(p, PE, T, CP / CV, R);
    Run run("interaction.k");
    const gas::UniformBag &full = run.scene.uniform_bags().at(0),
                          &other = run.scene.uniform_bags().at(1);
    run.steps(1);
    const double first = exchanged(rate, run.scene.time(), p, PE, T);
    CHECK(full.mass_out() == Approx(first).epsilon(1e-10));
    CHECK(other.mass_in() == Approx(first).epsilon(1e-10));
    run.to_the_end();
    CHECK(full.gas().mass() + other.gas().mass() == Approx(2.0 * RO * VOLUME).epsilon(1e-12));
    CHECK(full.mass_out() > 3.0 * first);
    CHECK(std::abs(full.pressure() - other.pressure()) < 0.05 * POVER);
    CHECK(run.residual < 1e-3 * 550.0);  // J that the gas holds
    CHECK(run.residual > 2.5 * residual_of_half_the_step(read("interaction.k")));
}

TEST_CASE("*AIRBAG_INTERACTION: through a part, by a curve, one way", "[io]") {
    Model model = read("interaction.k");
    gas::ExchangeCard& hole = model.exchanges.at(0);
    const double p = PE + POVER, T = p / (RO * R);
    SECTION("the wrong way") {
        hole.direction = 1;
        Run run(model);
        run.steps(5);
        CHECK(run.scene.uniform_bags()[0].mass_out() == 0.0);
    }
    SECTION("mass flow over pressure difference") {
        hole.direction = -1;
        hole.rate = static_cast<Index>(model.curves.size());
        model.curves.push_back({99, {0.0, 2.0 * POVER}, {0.0, 2.0}});
        Run run(model);
        run.steps(1);
        CHECK(run.scene.uniform_bags()[1].mass_in() ==
              Approx(exchanged(1.0, run.scene.time(), p, PE, T)).epsilon(1e-10));
    }
    SECTION("through the shells of a part") {
        hole.opening.area.value = 0.0;
        for (const Shell& shell : model.shells)
            if (model.parts[shell.part].id == 2) hole.opening.facets.push_back(shell.nodes);
        const double rate = 0.6 * 0.01 * gas::orifice_flow(p, PE, T, CP / CV, R);
        Run run(model);
        run.steps(1);
        CHECK(run.scene.uniform_bags()[1].mass_in() ==
              Approx(exchanged(rate, run.scene.time(), p, PE, T)).epsilon(1e-10));
    }
}

TEST_CASE("a tyre's pressure is that of its volume, and its work is from outside", "[io]") {
    Model model = read("pressure_volume.k");
    CHECK(tells(model.warnings, "is a pressure by volume"));
    SECTION("BETA CN / (V / V0)") {
        Run run(model);
        const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
        CHECK(bag.pressure() == Approx(20000.0).epsilon(1e-12));
        run.to_the_end();
        const double ratio = bag.state(run.scene.nodes().x).volume / VOLUME;
        CHECK(ratio > 1.02);
        CHECK(bag.pressure() == Approx(20000.0 / ratio).epsilon(1e-12));
        const EnergyBooks books = run.scene.books();
        CHECK(books.gas == 0.0);
        CHECK(books.external > 0.0);
        CHECK(run.residual < 0.05 * run.moved);
        CHECK(run.residual > 2.5 * residual_of_half_the_step(model));
    }
    SECTION("a curve of V / V0") {
        model.uniform_bags[0].law->curve = static_cast<Index>(model.curves.size());
        model.curves.push_back({99, {0.5, 1.5}, {40000.0, 0.0}});
        Run run(model);
        const gas::UniformBag& bag = run.scene.uniform_bags().at(0);
        run.steps(50);
        const double ratio = bag.state(run.scene.nodes().x).volume / VOLUME;
        CHECK(bag.pressure() == Approx(40000.0 * (1.5 - ratio)).epsilon(1e-12));
    }
}

TEST_CASE("a box for a rigid wall: the nodes in it alone are stopped", "[contact]") {
    Run run("wall_box.k");
    CHECK(run.scene.model().walls.at(0).nodes.size() == 17);  // of 26, those with x > 0.04
    double stopped = 0.0, free = 0.0;  // lower corners at x = 0.1 and at x = 0
    while (!run.scene.is_over()) {
        run.steps(1);
        stopped = std::min(stopped, run.x(10).z());
        free = std::min(free, run.x(1).z());
    }
    CHECK(stopped == Approx(-0.005).margin(1e-12));
    CHECK(free < -0.007);
}
