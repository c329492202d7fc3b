// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include "solver/base/error.hpp"
#include "solver/energy/growth_monitor.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"
#include "tests/unit/solver/energy/growth_setup.hpp"

using namespace corpuscle;
using namespace growth_setup;

TEST_CASE("energy from nowhere is noticed", "[solver][growth]") {
    GrowthMonitor monitor({0}, {1.0});
    const std::vector<double> mass{2.0};
    const Points v(1, Vec3(1, 0, 0));  // 1 J
    CHECK_FALSE(monitor.gains({0.0, 0.0, 0.0}, mass, v, v));
    CHECK_FALSE(monitor.gains({0.9, 0.0, 0.0}, mass, v, v));
    monitor.give(1.0);  // a reference shape that begins to count
    CHECK_FALSE(monitor.gains({1.5, 0.0, 0.0}, mass, v, v));
    CHECK(monitor.gains({3.5, 0.0, 0.0}, mass, v, v));
    CHECK(monitor.gained() == Approx(2.5));
    CHECK(monitor.scale() == Approx(2.0));
}

TEST_CASE("the first force that is not finite is named with its node", "[solver]") {
    Model loaded = sheet(scenes::cloth(), 4, false);
    loaded.pressure_loads[0].scale = INF;
    const std::string of_loads = stop(std::move(loaded), 0.9, 1e-3);
    CAPTURE(of_loads);
    CHECK(of_loads.find("the force of loads on node ") != std::string::npos);

    Model filled = bag(700.0, 20);
    filled.bags[0].p_atm = INF;
    const std::string of_gas = stop(std::move(filled), 0.9, 1e-3);
    CAPTURE(of_gas);
    CHECK(of_gas.find("the force of the gas of bag 1 on node ") != std::string::npos);
}
