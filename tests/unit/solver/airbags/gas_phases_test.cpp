// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What does not depend on whether gas is particles, air that is none, or uniform.
#include <catch2/catch.hpp>

#include <cmath>

#include "tests/unit/solver/airbags/outflow_setup.hpp"
#include "tests/unit/solver/airbags/two_chambers.hpp"

using namespace corpuscle;
using namespace outflow_setup;

TEST_CASE("a vent between rooms opens at the pressure of the one that gives, in every phase",
          "[solver][vents]") {
    constexpr double OPENS_AT = 0.4e5;
    Model model = chambered::two_chambers();
    gas::BagCard& bag = model.bags[0];
    bag.inflow.resize(1);  // into the large one alone
    bag.orifices.resize(1);
    bag.p_atm = P_ATM;
    bag.vents = {vent(1.0, false)};
    bag.vents[0].parts = {3};
    bag.vents[0].opens_at = OPENS_AT;
    std::vector<double> opened;
    for (const double switch_at : {1.0, 1e-6}) {
        bag.switch_at = switch_at;
        Simulation simulation(model);
        double before = 0.0, residual = 0.0;
        while (!simulation.is_over() && opened.size() < (switch_at < 1e-3 ? 2U : 1U)) {
            const std::vector<gas::ChamberState> rooms = chambered::chambers(simulation);
            if (rooms[1].mass > 0.0) opened.push_back(before);
            before = rooms[0].pressure;
            chambered::run_until(simulation, simulation.time() + 1e-9, residual);
        }
    }
    REQUIRE(opened.size() == 2);
    CHECK(opened[0] == Approx(P_ATM + OPENS_AT).epsilon(0.02));
    CHECK(opened[1] == Approx(P_ATM + OPENS_AT).epsilon(0.01));
}

TEST_CASE("parts of one vent let out what their areas say, in every phase", "[solver][vents]") {
    Model model = tank(4000);
    model.parts.push_back(model.parts[1]);
    model.parts[2].id = 3;
    model.shells.back().part = 2;  // the vent's two triangles are of a part each
    model.bags[0].external_parts.push_back(2);
    model.bags[0].vents = {vent(0.8, true)};
    model.bags[0].vents[0].parts = {1, 2};
    model.bags[0].switch_at = GENERATE(1e-6, 1.0);
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 6e-3, watch);
    const Sample sample = simulation.sample();
    const auto& parts = sample.airbags[0].parts;
    const double out = state(simulation).mass_out_vent;
    REQUIRE(parts.size() == 3);
    CHECK(out > 1e-4);
    CHECK(parts[1].mass_out + parts[2].mass_out == Approx(out).epsilon(1e-12));
    const double few = model.bags[0].switch_at < 1e-3 ? 1e-9 : 0.06;  // some 800 particles leave
    CHECK(parts[1].mass_out == Approx(0.5 * out).epsilon(few));
}

TEST_CASE("air in which few particles fly cools by Newton's law", "[solver][heat]") {
    Model model = tank(300, 1e-6, 6e-3);
    gas::InitialAirCard air;
    air.species = scenes::air();
    air.pressure = P_ATM;
    air.temperature = 300.0;
    model.bags[0].air = air;
    constexpr double H = 1250.0, AREA = 0.06 - 0.025 * 0.025;
    model.bags[0].heat = {{{0}, H, -1}};
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 6e-3, watch);
    const double moles = P_ATM * 1e-3 / (GAS_CONSTANT * 300.0);
    const double C = moles * (28.0 - GAS_CONSTANT);
    const double exact = 50.0 * -std::expm1(-H * AREA * simulation.time() / C);
    CHECK(exact > 10.0);
    CHECK(300.0 - state(simulation).temperature == Approx(exact).epsilon(0.02));
    CHECK(watch.residual < 1e-9 * C * 300.0);
}
