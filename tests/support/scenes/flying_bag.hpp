// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/particles.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

namespace corpuscle::scenes {

/// A closed bag of cloth in the open, with hot air blown into it.
inline Model flying_bag(std::size_t particles) {
    Model model = of(shapes::sphere(0.1, 3), cloth(), 3e-4);
    fill(model, air(), 5e-4, 1e-3, 600.0, {0.01, 0.02, -0.01}, particles);
    model.velocity.assign(model.x.size(), Vec3(3.0, 0.0, -1.0));
    return model;
}

struct Momentum {
    Vec3 fabric = Vec3::Zero(), gas = Vec3::Zero(), owed = Vec3::Zero();
    [[nodiscard]] Vec3 all() const { return fabric + gas + owed; }
};
inline Momentum momentum(const Simulation& simulation) {
    Momentum sum;
    const auto& nodes = simulation.nodes();
    for (std::size_t n = 0; n < nodes.size(); ++n) sum.fabric += nodes.mass[n] * nodes.v[n];
    for (const gas::BagGas& bag : simulation.bags()) {
        const auto& gas = bag.particles();
        for (std::size_t i = 0; i < gas.size(); ++i)
            sum.gas += bag.particle_mass()[gas.species[i]] * gas.v[i];
        sum.owed += bag.owed().linear;
    }
    return sum;
}

}  // namespace corpuscle::scenes
