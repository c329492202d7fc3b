// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

namespace outflow_setup {

using namespace corpuscle;

inline constexpr double P_ATM = 1e5;
inline const auto nothing = [](Simulation&) {};

/// A rigid tank of one litre: part 1, and the last two triangles of it part 2.
inline Model tank(std::size_t particles, double mass = 2.5e-3, double until = 2e-3) {
    Model model = scenes::of(shapes::box(Vec3::Constant(0.1), 4), scenes::null_material(), 1e-3);
    model.parts.push_back(model.parts[0]);
    model.parts[1].id = 2;
    model.shells[model.shells.size() - 1].part = model.shells[model.shells.size() - 2].part = 1;
    scenes::fill(model, scenes::air(), mass, until, 300.0, {0.05, 0.05, 0.05}, particles);
    model.bags[0].p_atm = P_ATM;
    model.bags[0].T_atm = 250.0;
    scenes::fix_all_nodes(model);
    model.end_time = 6e-3;
    return model;
}

inline gas::VentCard vent(double C23, bool is_isentropic) {
    gas::VentCard card;
    card.parts = {1};
    card.coefficient = C23;
    card.is_isentropic = is_isentropic;
    return card;
}

struct Watch {
    double residual = 0.0;
    void operator()(Simulation& now) {
        residual = std::max(residual, std::abs(now.books().residual));
    }
};

inline gas::GasState state(const Simulation& simulation) {
    return simulation.bags()[0].state(simulation.nodes().x);
}

inline void run_until(Simulation& simulation, double t, Watch& watch) {
    while (!simulation.is_over() && simulation.time() < t)
        simulation.step([&](Simulation& now) { watch(now); });
}

}  // namespace outflow_setup
