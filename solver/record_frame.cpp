// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// One state of the whole scene, for pictures.

#include "gas/particles.hpp"
#include "solver/recorder.hpp"

namespace corpuscle {
namespace {

/// Of a shell of the model, nodes at x.                                                    [m^2]
double shell_area(const SceneState& scene, std::size_t shell) {
    const auto& n = scene.model.shells[shell].nodes;
    const Points& x = scene.nodes.x;
    return vector_area(x[n[0]], x[n[1]], x[n[2]]).norm() +
           vector_area(x[n[0]], x[n[2]], x[n[3]]).norm();
}

/// Of shells without contact 0.
void add_contact_pressure(SceneState& scene, std::vector<float>& pressure) {
    if (scene.obstacles.contact) {
        const std::vector<double> force = scene.obstacles.contact->take_facet_forces(scene.nodes.x);
        std::vector<double> on_shell(scene.model.shells.size(), 0.0);
        for (std::size_t t = 0; t < force.size(); ++t)
            on_shell[scene.obstacles.contact_shell[t]] += force[t];
        for (std::size_t s = 0; s < on_shell.size(); ++s) {
            const double area = shell_area(scene, s);
            pressure.push_back(area > 0.0 ? static_cast<float>(on_shell[s] / area) : 0.0F);
        }
    }
}

/// Gauge, of what the gas does on average over `since`; across a shell of two bags the difference,
/// outward of the first bag.
void add_gas_pressure(SceneState& scene, double since, std::vector<float>& pressure) {
    const std::size_t shells = scene.model.shells.size();
    gas::ShellLoad load(shells);
    for (gas::BagGas& bag : scene.airbags.particle) bag.add_shell_load(scene.nodes.x, since, load);
    for (gas::UniformBag& bag : scene.airbags.uniform)
        bag.add_shell_load(scene.nodes.x, since, load);
    pressure.resize(shells);
    for (std::size_t s = 0; s < shells; ++s) {
        const double area = load.facing[s] != 0 ? shell_area(scene, s) : 0.0;
        pressure[s] = area > 0.0 ? static_cast<float>(load.force[s] / area) : 0.0F;
    }
}

void add_particles(const SceneState& scene, Frame& state) {
    for (const gas::BagGas& bag : scene.airbags.particle) {
        if (!bag.card().show_particles) continue;
        if (!state.particles) state.particles.emplace();
        if (bag.is_uniform()) continue;  // its particles are summed up and stand where they froze
        const gas::Particles& from = bag.particles();
        for (std::size_t i = 0; i < from.size(); ++i) {
            state.particles->id.push_back(from.id[i]);
            state.particles->bag.push_back(bag.card().id);
            const auto kind = static_cast<std::size_t>(from.species[i]);
            const bool is_air = kind == bag.card().inflow.size();
            state.particles->species.push_back(is_air ? 0 : from.species[i] + 1);
            state.particles->mass.push_back(bag.particle_mass()[from.species[i]]);
            state.particles->temperature.push_back(static_cast<float>(bag.particle_temperature(i)));
        }
        const auto append = [](auto& to, const auto& more) {
            to.insert(to.end(), more.begin(), more.end());
        };
        append(state.particles->position, from.x);
        append(state.particles->velocity, from.v);
        append(state.particles->internal_energy, from.e);
    }
}

}  // namespace

Frame Recorder::frame(SceneState& scene) {
    Frame state;
    state.time = scene.clock.t;
    state.coordinates = scene.nodes.x;
    state.velocity.resize(scene.nodes.size());
    for (std::size_t n = 0; n < scene.nodes.size(); ++n)
        state.velocity[n] = scene.velocity(static_cast<Index>(n));
    const std::size_t shells = scene.model.shells.size();
    state.shell_active.assign(shells, 1);
    state.shell_stress.assign(shells, {0.0F, 0.0F, 0.0F});
    state.shell_strain.assign(shells, {0.0F, 0.0F, 0.0F});
    if (scene.cloth.membranes)
        scene.cloth.membranes->stress_strain(scene.nodes.x, state.shell_stress, state.shell_strain);
    const double since = scene.clock.t - last_frame_;
    last_frame_ = scene.clock.t;
    add_gas_pressure(scene, since, state.shell_pressure);
    add_contact_pressure(scene, state.shell_contact_pressure);
    add_particles(scene, state);
    return state;
}

}  // namespace corpuscle
