// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what a tank's gas does is the same whether the tank rests or flies evenly [Galilei].
#include <catch2/catch.hpp>

#include <cmath>

#include "gas/particles.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/flying_bag.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/unit/solver/airbags/outflow_setup.hpp"

using namespace corpuscle;
using namespace outflow_setup;

namespace {

const Vec3 FLIGHT(120.0, -90.0, 0.0);
constexpr double TANK_HEAT = 300.0, TANK_MASS = 2.5e-3, AIR_GAMMA = 28.0 / (28.0 - GAS_CONSTANT);

/// The tank of outflow_setup.hpp with walls and orifice that fly.
Model flying_tank(std::size_t particles, const Vec3& velocity) {
    Model model = tank(particles, TANK_MASS);
    model.supports.clear();
    const auto steady = static_cast<Index>(model.curves.size());
    model.curves.push_back({90, {0.0, 1.0}, {1.0, 1.0}});
    for (int k = 0; k < 3; ++k) {
        PrescribedMotion motion;
        for (std::size_t n = 0; n < model.x.size(); ++n)
            motion.nodes.push_back(static_cast<Index>(n));
        motion.axis = Vec3::Unit(k);
        motion.curve = steady;
        motion.scale = velocity[k];
        model.motions.push_back(motion);
    }
    model.velocity.assign(model.x.size(), velocity);
    return model;
}

/// Energy of the tank's gas at rest.                                                          [J]
double energy_at_rest() {
    return TANK_MASS / 0.028 * (28.0 - GAS_CONSTANT) * TANK_HEAT;
}

/// Energy of the motion with the tank, of gas of momentum P: P·w - m w²/2.                    [J]
double ridden(const Vec3& P) {
    return P.dot(FLIGHT) - 0.5 * TANK_MASS * FLIGHT.squaredNorm();
}

}  // namespace

TEST_CASE("static pressure and temperature are without the flight, all others with it",
          "[solver][gas][galilei]") {
    Simulation simulation(flying_tank(4000, FLIGHT));
    Watch watch;
    run_until(simulation, 4e-3, watch);
    const gas::GasState now = state(simulation);
    const Vec3 P = scenes::momentum(simulation).gas;  // the gas sloshes in the tank a little
    const double motion = ridden(P), bulk = 0.5 * P.squaredNorm() / now.mass;
    CHECK(motion == Approx(0.05 * energy_at_rest()).epsilon(0.2));
    CHECK(now.energy == Approx(energy_at_rest() + motion).epsilon(1e-5));
    CHECK(now.temperature / TANK_HEAT == Approx(1.0 + motion / energy_at_rest()).epsilon(1e-5));
    CHECK(now.pressure == Approx(2.0 / 3.0 * now.translational / now.volume).epsilon(1e-14));
    CHECK(now.static_pressure ==
          Approx(2.0 / 3.0 * (now.translational - bulk) / now.volume).epsilon(1e-12));
    CHECK(now.static_temperature == Approx(TANK_HEAT).epsilon(1e-3));
    CHECK(now.static_pressure ==
          Approx(TANK_MASS / 0.028 * GAS_CONSTANT * TANK_HEAT / now.volume).epsilon(0.03));
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
}

TEST_CASE("at TSW the gas of a tank that flies has the energy of the gas at rest",
          "[solver][gas][galilei]") {
    Model model = flying_tank(2000, FLIGHT);
    model.bags[0].switch_at = 3e-3;
    Simulation simulation(model);
    Watch watch;
    double motion = 0.0;
    while (!simulation.is_over() && simulation.time() < 4e-3)
        simulation.step([&](Simulation& now) {
            if (!now.bags()[0].is_uniform()) motion = ridden(scenes::momentum(now).gas);
            watch(now);
        });
    REQUIRE(simulation.bags()[0].is_uniform());
    const gas::GasState now = state(simulation);
    CHECK(now.energy == Approx(energy_at_rest()).epsilon(1e-6));
    CHECK(now.temperature == Approx(TANK_HEAT).epsilon(1e-6));
    CHECK(now.static_temperature == now.temperature);
    CHECK(simulation.books().outflow == Approx(motion).epsilon(1e-9));  // is booked as gone
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
    double kept = 0.0;  // by the particles that are shown from then on
    for (const double e : simulation.bags()[0].particles().e) kept += e;
    CHECK(kept == Approx(now.energy).epsilon(1e-9));
}

TEST_CASE("a tank at the pressure outside keeps its gas however fast it flies",
          "[solver][vents][galilei]") {
    Model model = flying_tank(4000, FLIGHT);
    gas::BagCard& bag = model.bags[0];
    bag.p_atm = TANK_MASS / 0.028 * GAS_CONSTANT * TANK_HEAT / 1e-3;
    const auto opens = static_cast<Index>(model.curves.size());
    model.curves.push_back({91, {0.0, 3e-3, 3e-3, 1.0}, {0.0, 0.0, 1.0, 1.0}});
    const bool is_porous = GENERATE(false, true);
    if (is_porous) {
        fabric::FabricCard cloth;
        cloth.density = 1000.0;
        cloth.E_warp = cloth.E_weft = 1e8;
        cloth.G = 4e7;
        cloth.leak_area_curve = opens;
        cloth.leak_velocity = 60.0;
        model.materials.push_back({2, "", cloth});
        model.parts[0].material = 1;
    } else {
        bag.vents = {vent(GENERATE(1.0, 1.5), true)};  // above 1 it takes the state of the room
        bag.vents[0].time_curve = opens;
    }
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 6e-3, watch);
    const gas::GasState now = state(simulation);
    CHECK(now.mass_out_vent + now.mass_out_fabric < 2e-3 * TANK_MASS);
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
}

TEST_CASE("a tank that flies cools by Newton's law for its gas at rest",
          "[solver][heat][galilei]") {
    constexpr double H = 1250.0;  // [W/(m^2 K)]
    Model model = flying_tank(4000, FLIGHT);
    model.end_time = 12e-3;
    model.bags[0].heat = {{{0}, H, -1}};
    Simulation simulation(model);
    Watch watch;
    run_until(simulation, 2.5e-3, watch);
    const double capacity = TANK_MASS / 0.028 * (28.0 - GAS_CONSTANT);
    const double area = 0.06 - 0.5 * 2 * 0.025 * 0.025, t_0 = simulation.time();
    const double T_0 = state(simulation).static_temperature,
                 before = simulation.sample().airbags[0].parts[0].heat_lost;
    run_until(simulation, model.end_time, watch);
    const double exact =
        -capacity * (T_0 - 250.0) * std::expm1(-H * area * (simulation.time() - t_0) / capacity);
    CHECK(simulation.sample().airbags[0].parts[0].heat_lost - before ==
          Approx(exact).epsilon(0.03));
    CHECK(watch.residual < 1e-9 * simulation.bags()[0].inflow_energy());
}
