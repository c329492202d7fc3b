// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Bags of two chambers: states of their own, before and after the switch to uniform pressure.
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdint>

#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/unit/solver/airbags/two_chambers.hpp"

using namespace corpuscle;
using chambered::chambers;
using chambered::run_until;
using chambered::two_chambers;

TEST_CASE("each chamber has its own state, and keeps it when the pressure becomes uniform",
          "[solver][chambers]") {
    Model model = two_chambers();
    model.bags[0].switch_at = 1.5e-3;
    const bool has_air = GENERATE(false, true);
    if (has_air) model.bags[0].air = gas::InitialAirCard{scenes::air(), 2e4, 300.0};
    Simulation simulation(model);
    double residual = 0.0;
    run_until(simulation, 1.49e-3, residual);
    REQUIRE_FALSE(simulation.bags()[0].is_uniform());
    const auto before = chambers(simulation);
    CHECK(before[0].volume == Approx(1e-3));
    CHECK(before[1].volume == Approx(0.5e-3));
    if (!has_air) {
        CHECK(before[0].temperature == Approx(600.0).epsilon(1e-9));
        CHECK(before[1].temperature == Approx(300.0).epsilon(1e-9));
        CHECK(before[0].mass == Approx(1e-3).epsilon(1e-9));
    }
    run_until(simulation, 1.6e-3, residual);
    REQUIRE(simulation.bags()[0].is_uniform());
    const auto after = chambers(simulation);
    for (const std::size_t c : {0, 1}) {
        CHECK(after[c].mass == Approx(before[c].mass).epsilon(1e-12));
        // Heat goes between particles and the uniform air until the switch.
        CHECK(after[c].energy == Approx(before[c].energy).epsilon(has_air ? 1e-2 : 1e-9));
        CHECK(after[c].temperature == Approx(before[c].temperature).epsilon(has_air ? 1e-2 : 1e-9));
    }
    run_until(simulation, 1.0, residual);
    CHECK(chambers(simulation)[0].energy == Approx(after[0].energy).epsilon(1e-12));
    CHECK(residual < 1e-9 * simulation.bags()[0].inflow_energy());
    // The wall is pushed by the difference, the hull by its own chamber.
    simulation.close([&](Simulation& at_end) {
        const AirbagSample bag = at_end.sample().airbags[0];
        REQUIRE(bag.chambers.size() == 2);
        CHECK(bag.chambers[1].pressure == Approx(after[1].pressure));
    });
}

TEST_CASE("pressure of a chamber's particles is that of its gas when it is uniform",
          "[solver][chambers]") {
    constexpr int SEEDS =
        16;  // one seed scatters by some 1 %: sound, and energy that goes to and fro
    const bool has_air = GENERATE(false, true);
    std::array<double, 2> mean{};
    for (int seed = 1; seed <= SEEDS; ++seed) {
        Model model = two_chambers();
        model.bags[0].switch_at = 1.5e-3;
        if (has_air) model.bags[0].air = gas::InitialAirCard{scenes::air(), 2e4, 300.0};
        Simulation simulation(model, static_cast<std::uint64_t>(seed));
        double residual = 0.0;
        run_until(simulation, 1.49e-3, residual);
        const auto before = chambers(simulation);
        run_until(simulation, 1.6e-3, residual);
        const auto after = chambers(simulation);
        for (const std::size_t c : {0, 1})
            mean[c] += before[c].pressure / after[c].pressure / SEEDS;
    }
    CHECK(mean[0] == Approx(1.0).epsilon(0.01));
    CHECK(mean[1] == Approx(1.0).epsilon(0.01));
}

TEST_CASE("a hole between chambers lets gas through as a nozzle does, until pressures are even",
          "[solver][chambers]") {
    Model model = two_chambers();
    model.bags[0].switch_at = 1.2e-3;
    model.bags[0].all_in = 1e-3;
    gas::VentCard hole;
    hole.parts = {3};
    hole.coefficient = 0.8;
    model.curves.push_back({9, {0.0, 1.3e-3, 1.300001e-3, 1.0}, {0.0, 0.0, 1.0, 1.0}});
    hole.time_curve = static_cast<Index>(model.curves.size() - 1);
    model.bags[0].vents = {hole};
    model.end_time = 40e-3;
    Simulation simulation(model);
    double residual = 0.0;
    run_until(simulation, 1.35e-3, residual);
    // From here on by the equations of the two rooms, small steps.
    auto now = chambers(simulation);
    double t = simulation.time();
    const double area = 0.8 * 0.5 * (0.1 / 3.0) * (0.1 / 3.0), gamma = 28.0 / (28.0 - GAS_CONSTANT);
    const double R = GAS_CONSTANT / 0.028, cv = (28.0 - GAS_CONSTANT) / 0.028;
    for (const double look : {1.8e-3, 3e-3}) {
        run_until(simulation, look, residual);
        constexpr int STEPS = 20000;
        const double dt = (simulation.time() - t) / STEPS;
        for (int i = 0; i < STEPS; ++i) {
            for (auto& room : now) {
                room.temperature = room.energy / (room.mass * cv);
                room.pressure = room.mass * R * room.temperature / room.volume;
            }
            auto& from = now[0].pressure > now[1].pressure ? now[0] : now[1];
            auto& to = &from == &now[0] ? now[1] : now[0];
            const double mass =
                area * dt *
                gas::orifice_flow(from.pressure, to.pressure, from.temperature, gamma, R);
            const double energy = mass * gamma * cv * from.temperature;
            from.mass -= mass, to.mass += mass;
            from.energy -= energy, to.energy += energy;
        }
        t = simulation.time();
        const auto found = chambers(simulation);
        for (const std::size_t c : {0, 1}) {
            CHECK(found[c].mass == Approx(now[c].mass).epsilon(2e-3));
            CHECK(found[c].energy == Approx(now[c].energy).epsilon(2e-3));
        }
    }
    run_until(simulation, 1.0, residual);
    const auto end = chambers(simulation);
    CHECK(end[0].pressure == Approx(end[1].pressure).epsilon(1e-6));
    CHECK(end[0].mass + end[1].mass == Approx(2e-3).epsilon(1e-9));
    CHECK(residual < 1e-9 * simulation.bags()[0].inflow_energy());
}

TEST_CASE("initial air passes an internal opening before the switch as the uniform gas does after",
          "[solver][chambers]") {
    const bool is_vent = GENERATE(true, false);
    Model model = two_chambers();
    model.bags[0].inflow.clear();
    model.bags[0].orifices.clear();
    model.bags[0].air = gas::InitialAirCard{scenes::air(), 3e5, 300.0};
    model.bags[0].p_atm = 1e5;
    for (Shell& shell : model.shells)
        if (shell.part == 1) {  // a triangle of the small chamber's end
            shell.part = 4;
            break;
        }
    model.parts.push_back(model.parts[1]);
    model.parts[4].id = 5;
    model.bags[0].external_parts.push_back(4);
    model.bags[0].chambers[1].parts.push_back(4);
    gas::VentCard out, hole;
    out.parts = {4};
    out.is_isentropic = true;
    hole.parts = {3};
    hole.coefficient = 0.7;
    model.bags[0].vents = {out};
    if (is_vent) {
        model.bags[0].vents.push_back(hole);
    } else {
        fabric::FabricCard cloth;
        cloth.density = 1000.0;
        cloth.E_warp = cloth.E_weft = 1e8;
        cloth.G = 4e7;
        cloth.leak_area = 0.7;
        cloth.leak_velocity = 1.0;
        cloth.leak_option = 3;
        model.materials.push_back({2, "", cloth});
        model.parts[3].material = 1;
    }
    model.end_time = 30e-3;
    Model switched = model;
    switched.bags[0].switch_at = 1e-9;
    Simulation before(model), after(switched);
    double residual = 0.0, other = 0.0;
    for (const double look : {1e-3, 3e-3, 8e-3}) {
        run_until(before, look, residual);
        run_until(after, look, other);
        const auto found = chambers(before), wanted = chambers(after);
        for (const std::size_t c : {0, 1}) {
            CHECK(found[c].mass == Approx(wanted[c].mass).epsilon(1e-3));
            // that of uniform gas is of the step's start
            CHECK(found[c].energy == Approx(wanted[c].energy).epsilon(6e-3));
        }
        CHECK(found[0].pressure < 2.9e5);
    }
    run_until(before, 1.0, residual);
    const auto end = chambers(before);
    CHECK(end[0].pressure == Approx(1e5).epsilon(1e-3));
    CHECK(end[1].pressure == Approx(1e5).epsilon(1e-3));
    CHECK(residual < 1e-12 * end[0].energy);
}

TEST_CASE("chambers that are not closed, overlap or leave some of the bag out are refused",
          "[solver][chambers]") {
    Model model = two_chambers();
    const auto fault = [&] {
        try {
            Simulation simulation(model);
        } catch (const InputError& error) {
            return error.faults.at(0);
        }
        return std::string("none");
    };
    auto& cards = model.bags[0].chambers;
    CHECK(fault() == "none");
    cards = {{21, {0, 2}}, {22, {1, 2, 3}}};
    CHECK(fault().find("not closed") != std::string::npos);
    cards = {{21, {0, 2, 3}}};
    CHECK(fault().find("closes the bag but no chamber") != std::string::npos);
    cards = {{21, {0, 2, 3}}, {22, {0, 2, 3}}};
    CHECK(fault().find("another chamber on the same side") != std::string::npos);
}
