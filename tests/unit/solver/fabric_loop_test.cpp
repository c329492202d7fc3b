// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

/// One triangle of a curved cloth that is pulled: two nodes held, one moves out along the warp.
Model pulled_triangle(bool unloads) {
    Model model = scenes::of({{Vec3(0, 0, 0), Vec3(0.1, 0, 0), Vec3(0, 0.1, 0)}, {{0, 1, 2}}},
                             scenes::cloth(), 0.3e-3);
    fabric::FabricCard card;
    card.density = 700;
    card.E_warp = card.E_weft = 300e6;
    card.G = 3e6;
    card.form = 14;
    card.curves.load = {0, -1, -1};
    model.curves = {{1, {0, 0.3}, {0, 30e6}}, {2, {0, 0.2, 0.3}, {0, 5e6, 30e6}}};
    if (unloads) card.curves.unload = {1, -1, -1};
    model.materials[0].card = card;
    model.supports = {{0, 7U}, {2, 7U}, {1, 6U}};
    model.velocity[1] = {40, 0, 0};
    model.end_time = 5e-3;
    return model;
}

}  // namespace

TEST_CASE("what a loop of loading loses is booked as damping, and the books close", "[solver]") {
    const bool unloads = GENERATE(false, true);
    Model model = pulled_triangle(unloads);
    model.step_factor = 0.1;
    Simulation simulation(std::move(model));
    EnergyBooks first, last;
    bool is_first = true;
    double worst = 0.0;
    const auto look = [&](Simulation& s) {
        last = s.books();
        if (is_first) first = last;
        is_first = false;
        worst = std::max(worst, std::abs(last.residual));
    };
    while (!simulation.is_over()) simulation.step(look);
    simulation.close(look);
    CHECK(worst < 0.01 * first.kinetic);
    if (unloads) CHECK(last.damping > 0.3 * first.kinetic);
    if (!unloads) CHECK(last.damping == 0.0);
}
