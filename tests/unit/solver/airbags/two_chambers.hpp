// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

/// A bag of two chambers.
namespace corpuscle::chambered {

/// A tank 0.1 x 0.1 x 0.15 m that a wall at z = 0.1 parts: parts 1 and 2 are the hulls of the large
/// and the small chamber, 3 is the wall and 4 one of its triangles, a hole if it is made one.
/// Hot gas flows into the large one, cold into the small one, 1 g each until 1 ms.
inline Model two_chambers() {
    constexpr int N = 3;
    Model model;
    std::map<std::array<int, 3>, Index> rows;
    const auto node = [&](int i, int j, int k) {
        const auto [at, fresh] = rows.try_emplace({i, j, k}, static_cast<Index>(model.x.size()));
        if (fresh) model.x.push_back(Vec3(0.1 * i / N, 0.1 * j / N, 0.05 * k));
        return at->second;
    };
    const auto quad = [&](Index part, Index a, Index b, Index c, Index d) {
        const auto id = static_cast<int>(model.shells.size()) + 1;
        model.shells.push_back({id, part, {a, b, c, c}});
        model.shells.push_back({id + 1, part, {a, c, d, d}});
    };
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j)
            for (const auto& [k, part] : {std::pair(0, 0), std::pair(3, 1), std::pair(2, 2)})
                quad(part, node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k),
                     node(i, j + 1, k));
    for (int i = 0; i < N; ++i)
        for (int k = 0; k < 3; ++k)
            for (const int side : {0, N}) {
                const Index part = k < 2 ? 0 : 1;
                quad(part, node(i, side, k), node(i + 1, side, k), node(i + 1, side, k + 1),
                     node(i, side, k + 1));
                quad(part, node(side, i, k), node(side, i + 1, k), node(side, i + 1, k + 1),
                     node(side, i, k + 1));
            }
    for (Shell& shell : model.shells)
        if (shell.part == 2) {
            shell.part = 3;
            break;
        }
    model.unit_system = "SI";
    model.parts.resize(4);
    for (int p = 0; p < 4; ++p) {
        model.parts[static_cast<std::size_t>(p)].id = p + 1;
        model.parts[static_cast<std::size_t>(p)].material = 0;
        model.parts[static_cast<std::size_t>(p)].thickness = 1e-3;
    }
    model.materials = {{1, "", scenes::null_material()}};
    model.velocity.assign(model.x.size(), Vec3::Zero());
    for (std::size_t n = 0; n < model.x.size(); ++n) model.node_id.push_back(static_cast<int>(n));
    scenes::fill(model, scenes::air(), 1e-3, 1e-3, 600.0, {0.05, 0.05, 0.06}, 4000);
    scenes::fill(model, scenes::air(), 1e-3, 1e-3, 300.0, {}, 4000);
    gas::BagCard& bag = model.bags[0];
    bag.external_parts = {0, 1};
    bag.internal_parts = {2, 3};
    bag.chambers = {{21, {0, 2, 3}}, {22, {1, 2, 3}}};
    bag.inflow[1].inflator = 2;
    gas::OrificeCard cold;
    cold.node = static_cast<Index>(model.x.size());
    cold.inflator = 2;
    bag.orifices.push_back(cold);
    model.x.emplace_back(0.05, 0.05, 0.12);
    model.velocity.push_back(Vec3::Zero());
    model.node_id.push_back(static_cast<int>(model.x.size()));
    scenes::fix_all_nodes(model);
    model.end_time = 2e-3;
    return model;
}

inline std::vector<gas::ChamberState> chambers(const Simulation& simulation) {
    return simulation.bags()[0].chamber_states(simulation.nodes().x);
}

inline void run_until(Simulation& simulation, double t, double& residual) {
    while (!simulation.is_over() && simulation.time() < t)
        simulation.step([&](Simulation& now) {
            residual = std::max(residual, std::abs(now.books().residual));
        });
}

/// Two stirred tanks that pass their gas to each other with its enthalpy, after a time:
/// dm_c/dt = w (ρ_d - ρ_c).
/// @param flow   w, of volume, each way                                                   [m^3/s]
/// @param gamma  of the gas                                                                   [-]
inline void seep(std::vector<gas::ChamberState>& tanks, double flow, double gamma, double time) {
    constexpr int STEPS = 20000;
    const double dt = time / STEPS;
    for (int i = 0; i < STEPS; ++i) {
        std::array<double, 2> mass{}, h{};
        for (const std::size_t c : {0, 1}) {
            mass[c] = flow * dt * tanks[c].mass / tanks[c].volume;
            h[c] = gamma * tanks[c].energy / tanks[c].mass;
        }
        for (const std::size_t c : {0, 1}) {
            tanks[c].mass += mass[1 - c] - mass[c];
            tanks[c].energy += mass[1 - c] * h[1 - c] - mass[c] * h[c];
        }
    }
}

}  // namespace corpuscle::chambered
