// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rooms of a bag: what is told of each alone.
#include <catch2/catch.hpp>

#include "solver/simulation.hpp"
#include "tests/unit/solver/airbags/two_chambers.hpp"

using namespace corpuscle;

TEST_CASE("after the switch a sensor reads the room that it lies in, be it a chamber or not",
          "[solver][chambers]") {
    Model model = chambered::two_chambers();
    model.bags[0].switch_at = 1.2e-3;
    const int chambers = GENERATE(0, 1, 2);  // one: of two rooms
    if (chambers == 0) model.bags[0].chambers.clear();
    if (chambers == 1) model.bags[0].chambers = {{21, {0, 1}}};
    // Beside a segment at z = 0 whose normal points into the large room; the small one is behind it
    for (const double offset : {0.05, 0.12})
        model.sensors.push_back(
            {gas::SensorCard::Shape::SPHERE, model.shells[0].nodes, offset, {0.01}});
    Simulation simulation(model);
    double residual = 0.0;
    chambered::run_until(simulation, 1.0, residual);
    simulation.close([&](Simulation& at_end) {
        const auto sensors = at_end.sample().sensors;
        const double T[] = {600.0, 300.0}, volume[] = {1e-3, 0.5e-3};
        for (const std::size_t k : {0, 1}) {
            CHECK(sensors[k].density == Approx(1e-3 / volume[k]).epsilon(1e-9));
            CHECK(sensors[k].temperature == Approx(T[k]).epsilon(1e-9));
            CHECK(sensors[k].pressure ==
                  Approx(1e-3 / 0.028 * GAS_CONSTANT * T[k] / volume[k]).epsilon(1e-9));
        }
    });
}
