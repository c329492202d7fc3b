// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Porous fabric between rooms whose gas is particles: each side passes by its own gas.
#include <catch2/catch.hpp>

#include <array>
#include <vector>

#include "solver/simulation.hpp"
#include "tests/unit/solver/airbags/two_chambers.hpp"

using namespace corpuscle;

namespace {

/// The two chambers; all of the wall between them but for a triangle is porous.
/// @param opens_at  FLC is 0 before                                                         [s]
Model with_porous_wall(double area_factor, double velocity, double opens_at) {
    Model model = chambered::two_chambers();
    fabric::FabricCard cloth;
    cloth.density = 1000.0;
    cloth.E_warp = cloth.E_weft = 1e8;
    cloth.G = 4e7;
    cloth.leak_velocity = velocity;
    cloth.leak_option = 7;
    model.curves.push_back(
        {9, {0.0, opens_at, opens_at + 1e-6, 1.0}, {0.0, 0.0, area_factor, area_factor}});
    cloth.leak_area_curve = static_cast<Index>(model.curves.size() - 1);
    model.materials.push_back({2, "", cloth});
    model.parts[2].material = 1;
    return model;
}

}  // namespace

TEST_CASE("particles pass fabric between rooms by the gas of the side that they come from",
          "[solver][chambers]") {
    // Hot gas in one room, cold in the other; from 3 ms on density · area · FLC · FAC each way
    constexpr double FLC = 0.2, FAC = 10.0, OPENS = 3e-3, R = GAS_CONSTANT / 0.028, CP = 1000.0;
    Model model = with_porous_wall(FLC, FAC, OPENS);
    model.bags[0].particles = 20000;
    model.end_time = 7e-3;
    Simulation simulation(model);
    double residual = 0.0;
    chambered::run_until(simulation, OPENS, residual);
    auto wanted = chambered::chambers(simulation);
    const double from = simulation.time(), wall = 0.01 - 0.5 * (0.1 / 3.0) * (0.1 / 3.0);
    chambered::run_until(simulation, 6.9e-3, residual);
    chambered::seep(wanted, wall * FLC * FAC, CP / (CP - R), simulation.time() - from);
    const auto found = chambered::chambers(simulation);
    for (const std::size_t c : {0, 1}) {
        CAPTURE(c);
        CHECK(found[c].mass == Approx(wanted[c].mass).epsilon(0.02));
        CHECK(found[c].energy == Approx(wanted[c].energy).epsilon(0.02));
    }
    CHECK(residual < 1e-10 * found[0].energy);
}
