// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include "solver/base/error.hpp"
#include "solver/energy/growth_monitor.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

namespace growth_setup {

using namespace corpuscle;

inline fabric::MaterialCard woven() {
    fabric::FabricCard card;
    card.density = 700;
    card.E_warp = 300e6;
    card.E_weft = 250e6;
    card.nu_ba = 0.1;
    card.G = 3e6;
    card.no_compression = true;
    return card;
}

/// A flat sheet of n × n cells, its rim held, blown up by pressure.
inline Model sheet(const fabric::MaterialCard& card, int n, bool triangles) {
    Model model = scenes::of({}, card, 3e-4);
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            if (i == 0 || j == 0 || i == n || j == n)
                model.supports.push_back({static_cast<Index>(model.x.size()), 7U});
            model.x.push_back({0.2 * i / n, 0.2 * j / n, 0.0});
            model.node_id.push_back(static_cast<int>(model.x.size()));
            model.velocity.push_back(Vec3::Zero());
        }
    const auto add = [&](Index a, Index b, Index c, Index d) {
        model.shells.push_back({static_cast<int>(model.shells.size()) + 1, 0, {a, b, c, d}});
    };
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
            if (!triangles) add(a, b, c, d);
            if (triangles) add(a, b, c, c);
            if (triangles) add(a, c, d, d);
        }
    PressureLoad load;
    load.scale = -20e3;
    for (const Shell& shell : model.shells) load.facets.push_back(shell.nodes);
    model.pressure_loads = {load};
    return model;
}

inline Model sphere(const fabric::MaterialCard& card) {
    Model model = scenes::of(shapes::sphere(0.1, 2), card, 3e-4);
    PressureLoad load;
    load.scale = -20e3;
    for (const Shell& shell : model.shells) load.facets.push_back(shell.nodes);
    model.pressure_loads = {load};
    return model;
}

/// A cube of light cloth at rest, its floor held, air inside and out; hot helium begins to flow at
/// 0.1 ms. So fine that the cloth sets the step.
inline Model bag(double density, std::size_t particles) {
    auto card = woven();
    std::get<fabric::FabricCard>(card).density = density;
    Model model = scenes::of(shapes::box(Vec3(0.1, 0.1, 0.1), 7), card, 2e-4);
    for (std::size_t n = 0; n < model.x.size(); ++n)
        if (model.x[n].z() == 0.0) model.supports.push_back({static_cast<Index>(n), 7U});
    scenes::fill(model, scenes::helium(), 1e-4, 1e-3, 600.0, Vec3(0.05, 0.05, 0.02), particles);
    for (double& t : model.curves[0].x) t += 1e-4;
    gas::InitialAirCard air;
    air.species = scenes::air();
    air.pressure = model.bags[0].p_atm = ATMOSPHERE_PRESSURE;
    air.temperature = ATMOSPHERE_TEMPERATURE;
    air.is_particles = true;
    model.bags[0].air = air;
    return model;
}

struct Stop {
    std::string why;  ///< empty: nothing stopped it
    double time;      ///< [s]
    std::int64_t steps;
};
inline Stop stop_of(Model model, double factor, double time, std::uint64_t seed = 1) {
    model.step_factor = factor;
    model.end_time = time;
    Simulation simulation(std::move(model), seed);
    try {
        while (!simulation.is_over()) simulation.step([](Simulation&) {});
    } catch (const PhysicsError& error) {
        return {error.what(), simulation.time(), simulation.steps()};
    }
    return {{}, simulation.time(), simulation.steps()};
}

/// What stops a scene within `time`; empty when nothing does.
inline std::string stop(Model model, double factor, double time) {
    return stop_of(std::move(model), factor, time).why;
}

}  // namespace growth_setup
