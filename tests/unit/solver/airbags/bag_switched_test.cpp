// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include "solver/simulation.hpp"
#include "tests/support/scenes/flying_bag.hpp"

using namespace corpuscle;
using scenes::flying_bag;
using scenes::momentum;

TEST_CASE("gas flows on by its curve after the switch", "[solver][gas]") {
    Model model = scenes::of(shapes::box({0.1, 0.1, 0.1}, 1), scenes::null_material(), 1e-3);
    scenes::fix_all_nodes(model);
    scenes::fill(model, scenes::air(), 1e-3, 2e-3, 600.0, {0.05, 0.05, 0.05}, 1000);
    model.end_time = 3e-3;
    model.bags[0].switch_at = GENERATE(1e-6, 1e-3);
    Simulation simulation(model);
    bool is_full = false;  // sampled once: mean pressures count from there
    while (!simulation.is_over())
        simulation.step([&](Simulation& at_t) {
            if (!is_full && at_t.time() > 2.1e-3) is_full = true, at_t.sample();
        });
    simulation.close([&](Simulation& at_end) {
        const AirbagSample bag = at_end.sample().airbags[0];
        CHECK(bag.mass == Approx(1e-3).epsilon(1e-3));  // one particle
        CHECK(bag.temperature == Approx(600.0).epsilon(1e-6));
        CHECK(bag.pressure == Approx(bag.mass * GAS_CONSTANT / 0.028 * 600.0 / 1e-3).epsilon(1e-6));
        CHECK(bag.species.at(0).energy == Approx(bag.energy).epsilon(1e-12));
        CHECK(bag.parts.at(0).pressure == Approx(bag.pressure).epsilon(2e-3));
        CHECK(std::abs(at_end.books().residual) < 1e-9 * at_end.books().inflow);
    });
}

TEST_CASE("after the switch a vented tank blows down by the equations of Wang and Nefske",
          "[solver][gas]") {
    Model model = scenes::of(shapes::box({0.1, 0.1, 0.1}, 4), scenes::null_material(), 1e-3);
    scenes::fix_all_nodes(model);
    model.parts.push_back(model.parts[0]);
    model.parts[1].id = 2;
    double area = 0.0;
    for (Shell& shell : model.shells) {  // one quad in the middle of a face
        const auto& [a, b, c, d] = shell.nodes;
        const Vec3 middle = (model.x[a] + model.x[b] + model.x[c]) / 3.0;
        if (middle.x() < 0.0999 || (middle - Vec3(0.1, 0.0625, 0.0625)).norm() > 0.0125) continue;
        shell.part = 1;
        area += vector_area(model.x[a], model.x[b], model.x[c]).norm();
    }
    REQUIRE(area == Approx(6.25e-4));
    scenes::fill(model, scenes::air(), 6e-3, 1e-3, 300.0, {0.05, 0.05, 0.05}, 2000);
    gas::BagCard& bag = model.bags[0];
    bag.p_atm = ATMOSPHERE_PRESSURE;
    bag.switch_at = 1.5e-3;
    gas::VentCard vent;
    vent.parts = {1};
    vent.coefficient = 0.5;
    vent.is_isentropic = true;
    bag.vents = {vent};
    model.end_time = 8e-3;
    Simulation simulation(model);

    constexpr double V = 1e-3;
    const double Rm = GAS_CONSTANT / 0.028, k = 28.0 / (28.0 - GAS_CONSTANT);
    const auto rate = [&](double m, double T) {
        const double p = m * Rm * T / V;
        if (p <= ATMOSPHERE_PRESSURE) return 0.0;
        const double Q =
            std::max(ATMOSPHERE_PRESSURE / p, std::pow(2.0 / (k + 1.0), k / (k - 1.0)));
        return 0.5 * area * p * std::pow(Q, 1.0 / k) *
               std::sqrt(2.0 * k / (k - 1.0) / (Rm * T) * (1.0 - std::pow(Q, (k - 1.0) / k)));
    };
    double m = 0.0, T = 0.0, t = 0.0, worst = 0.0, first = 0.0;
    const auto watch = [&](Simulation& at_t) {
        if (!at_t.bags()[0].is_uniform()) return;
        const gas::GasState now = at_t.bags()[0].state(at_t.nodes().x);
        if (m == 0.0) m = first = now.mass, T = now.temperature, t = at_t.time();
        while (t < at_t.time() - 1e-12) {  // what stays expands isentropically, T ~ m^(k - 1)
            const double dt = std::min(1e-7, at_t.time() - t), out = dt * rate(m, T);
            T *= std::pow(1.0 - out / m, k - 1.0);
            m -= out;
            t += dt;
        }
        worst = std::max(worst, std::abs(now.mass / m - 1.0));
        CHECK(now.temperature == Approx(T).epsilon(5e-3));
    };
    while (!simulation.is_over()) simulation.step(watch);
    CHECK(m < 0.7 * first);
    CHECK(worst < 5e-3);
    simulation.close([&](Simulation& at_end) {
        const AirbagSample end = at_end.sample().airbags[0];
        CHECK(end.mass + end.mass_out_vent == Approx(end.mass_in).epsilon(1e-9));
        CHECK(std::abs(at_end.books().residual) < 1e-9 * at_end.books().inflow);
    });
}
