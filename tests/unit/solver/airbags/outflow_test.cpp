// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas and heat that leave a bag, in whole scenes.
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

#include "gas/particles.hpp"
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/unit/solver/airbags/outflow_setup.hpp"

using namespace corpuscle;
using namespace outflow_setup;

namespace {

constexpr double H = 1250.0;  ///< of the wall that is cooled                          [W/(m^2 K)]

/// A tank of 3 000 particles that loses heat through its first part.
Model cooled_tank(const gas::HeatCard& heat) {
    Model model = tank(3000);
    model.end_time = 16.5e-3;
    model.bags[0].heat = {heat};
    return model;
}

}  // namespace

// The state at a patch of the wall comes from its hits: one run scatters by 0.1 %, and the gas that
// hits is 0.05 % of T colder than the room.
TEST_CASE("a tank cools by Newton's law and books its heat", "[solver][heat]") {
    constexpr int SEEDS = 8;
    const Model model = cooled_tank({{0}, H, -1});
    const double moles = 2.5e-3 / 0.028, C = moles * (28.0 - GAS_CONSTANT);
    const double area = 0.06 - 0.5 * 2 * 0.025 * 0.025;
    double fallen = 0.0, exact = 0.0;
    for (int seed = 1; seed <= SEEDS; ++seed) {
        Simulation simulation(model, static_cast<std::uint64_t>(seed));
        Watch watch;
        run_until(simulation, 2.5e-3, watch);
        const double T_0 = state(simulation).temperature, t_0 = simulation.time();
        run_until(simulation, model.end_time, watch);
        fallen += (T_0 - state(simulation).temperature) / SEEDS;
        exact -= (T_0 - 250.0) * std::expm1(-H * area * (simulation.time() - t_0) / C) / SEEDS;
        CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
        const Sample sample = simulation.sample();
        const auto& parts = sample.airbags[0].parts;
        CHECK(parts[1].heat_lost == 0.0);
        // what has not been drawn from the gas yet is that of a step or two
        CHECK(parts[0].heat_lost == Approx(simulation.books().outflow).epsilon(0.02));
    }
    CHECK(exact > 10.0);
    CHECK(fallen == Approx(exact).epsilon(0.01));
}

TEST_CASE("a curve of heat that stays at a value cools as that value does", "[solver][heat]") {
    Model by_curve = cooled_tank({{0}, 0.0, 0});
    by_curve.bags[0].heat[0].curve = static_cast<Index>(by_curve.curves.size());
    by_curve.curves.push_back({99, {0.0, 1.0}, {H, H}});
    std::vector<double> lost;
    for (Model model : {cooled_tank({{0}, H, -1}), by_curve}) {
        model.end_time = 4e-3;
        Simulation simulation(std::move(model));
        Watch watch;
        run_until(simulation, 4e-3, watch);
        lost.push_back(simulation.sample().airbags[0].parts[0].heat_lost);
    }
    CHECK(lost[0] > 0.0);
    CHECK(lost[1] == lost[0]);
}

TEST_CASE("a vent with PPOP opens at that gauge pressure and stays open", "[solver][vents]") {
    Model model = tank(4000);
    model.bags[0].vents = {vent(0.8, true)};
    model.bags[0].vents[0].opens_at = 0.8e5;
    Simulation simulation(model);
    bool was_closed = false, stayed_open = false;
    double before = 0.0;
    const auto look = [&](Simulation& now) {
        const gas::GasState gas = state(now);
        if (gas.pressure < 1.7e5 && now.time() < 2e-3) {
            was_closed = true;
            CHECK(gas.mass_out_vent == 0.0);
        }
        // without any more inflow the pressure falls below what has opened it, and gas still leaves
        stayed_open |= now.time() > 2.2e-3 && gas.pressure < 1.7e5 && gas.mass_out_vent > before;
        before = gas.mass_out_vent;
    };
    model.end_time = 8e-3;
    while (!simulation.is_over()) simulation.step(look);
    CHECK(was_closed);
    CHECK(before > 1e-4);
    CHECK(stayed_open);
}

TEST_CASE("ambient air comes in through a vent until the pressures are even", "[solver][vents]") {
    Model model = tank(2000, 1e-5);
    gas::InitialAirCard air;
    air.species = scenes::air();
    air.pressure = 0.4 * P_ATM;
    air.temperature = 300.0;
    air.flows_in = true;
    model.bags[0].air = air;
    model.bags[0].vents = {vent(1.0, true)};
    model.end_time = 8e-3;
    Simulation simulation(model);
    const double start = state(simulation).mass;
    Watch watch;
    run_until(simulation, 8e-3, watch);
    const gas::GasState now = state(simulation);
    CHECK(now.pressure == Approx(P_ATM).epsilon(0.02));
    // dU = h(T_atm) dm of a tank that fills, the inflator's little gas aside
    const double brought = now.mass_in - 1e-5;
    const double T =
        (start * 300.0 + 28.0 / (28.0 - GAS_CONSTANT) * brought * 250.0) / (start + brought);
    CHECK(now.temperature == Approx(T).epsilon(0.02));
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
}

TEST_CASE("flow through a vent ends at the pressure outside, however long the step",
          "[solver][vents]") {
    Model model = tank(2000);
    model.bags[0].inflow.clear();
    model.bags[0].orifices.clear();
    gas::InitialAirCard air;
    air.species = scenes::air();
    air.pressure = GENERATE(0.5, 2.0) * P_ATM;
    air.temperature = 600.0;
    air.flows_in = true;
    model.bags[0].air = air;
    model.bags[0].vents = {vent(1.0, true)};
    model.bags[0].switch_at = GENERATE(1e-9, 1.0);
    model.end_time = 0.5;  // steps of a thousandth of it
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 0.1, watch);
    const gas::GasState early = state(simulation);
    run_until(simulation, 1.0, watch);
    const gas::GasState late = state(simulation);
    CHECK(late.pressure == Approx(P_ATM).epsilon(1e-6));
    CHECK(late.mass_in - early.mass_in < 1e-6 * late.mass);
    CHECK(late.mass_out_vent - early.mass_out_vent < 1e-6 * late.mass);
    CHECK(watch.residual < 1e-9 * late.energy);
}

TEST_CASE("initial air leaves by its share of the mixture", "[solver][vents]") {
    Model model = tank(4000);
    gas::InitialAirCard air;
    air.species = scenes::air();
    air.pressure = P_ATM;
    air.temperature = 300.0;
    model.bags[0].air = air;
    model.bags[0].vents = {vent(1.0, true)};
    model.bags[0].vents[0].time_curve = static_cast<Index>(model.curves.size());
    model.curves.push_back({98, {0.0, 2.5e-3, 2.5e-3, 1.0}, {0.0, 0.0, 1.0, 1.0}});
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 2.4e-3, watch);
    const gas::GasState before = state(simulation);
    run_until(simulation, 6e-3, watch);
    const gas::GasState after = state(simulation);
    CHECK(after.mass < 0.85 * before.mass);
    CHECK(after.species[0].mass / before.species[0].mass ==
          Approx(after.species[1].mass / before.species[1].mass).epsilon(0.01));
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
}

TEST_CASE("fabric with X0 to X3 leaks as an orifice of that area", "[solver][fabric]") {
    Model model = tank(8000);
    fabric::FabricCard cloth;
    cloth.density = 1000.0;
    cloth.E_warp = cloth.E_weft = 1e8;
    cloth.G = 4e7;
    cloth.leak_growth = {1e-3, 2e-3, 3e-3, 4e-3};
    model.materials.push_back({2, "", cloth});
    model.parts[0].material = 1;
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 2.2e-3, watch);
    const gas::GasState from = state(simulation);
    const double t_0 = simulation.time();
    run_until(simulation, 4e-3, watch);
    const gas::GasState to = state(simulation);
    const double p = 0.5 * (from.pressure + to.pressure);
    const double T = 0.5 * (from.temperature + to.temperature);
    const double rp = P_ATM / p;
    const double area = (0.06 - 2 * 0.5 * 0.025 * 0.025) * (1e-3 + 2e-3 + 3e-3 * rp + 4e-3 * rp);
    const double flow =
        area * gas::orifice_flow(p, P_ATM, T, 28.0 / (28.0 - GAS_CONSTANT), GAS_CONSTANT / 0.028);
    CHECK(to.mass_out_fabric - from.mass_out_fabric ==
          Approx(flow * (simulation.time() - t_0)).epsilon(0.03));
    CHECK(to.mass_out_vent == 0.0);
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
}

TEST_CASE("a bag of cloth that leaks and vents closes its books, whatever the threads",
          "[solver][vents][threads]") {
    const auto run = [](int threads, double& residual) {
        parallel::set_threads(threads);
        fabric::FabricCard cloth;
        cloth.density = 750.0;
        cloth.E_warp = cloth.E_weft = 300e6;
        cloth.nu_ba = 0.3;
        cloth.G = 115e6;
        cloth.leak_area = 0.02;
        cloth.leak_velocity = 50.0;
        Model model = scenes::of(shapes::sphere(0.1, 3), cloth, 3e-4);
        model.parts.push_back(model.parts[0]);
        model.parts[1].id = 2;
        for (std::size_t s = 0; s < 24; ++s) model.shells[s].part = 1;
        scenes::fill(model, scenes::air(), 2e-3, 1e-3, 600.0, {0.01, 0.02, -0.01}, 3000);
        model.bags[0].p_atm = 2e4;
        model.bags[0].vents = {vent(1.5, true)};
        model.bags[0].heat = {{{0}, 100.0, -1}};
        model.end_time = 2e-3;
        Simulation simulation(model, 5);
        Watch watch;
        run_until(simulation, 2e-3, watch);
        residual = watch.residual / simulation.bags()[0].inflow_energy();
        return simulation;
    };
    double residual = 0.0;
    const Simulation one = run(1, residual);
    CHECK(residual < 2e-3);
    CHECK(state(one).mass_out_vent > 1e-5);
    CHECK(state(one).mass_out_fabric > 1e-6);
    const Simulation two = run(2, residual);
    CHECK(one.nodes().x == two.nodes().x);
    CHECK(one.bags()[0].particles().id == two.bags()[0].particles().id);
    CHECK(one.bags()[0].particles().v == two.bags()[0].particles().v);
    CHECK(one.bags()[0].particles().e == two.bags()[0].particles().e);
}
