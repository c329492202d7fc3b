// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a run hands to its results.

#include "solver/base/parallel.hpp"
#include "solver/simulation.hpp"

namespace corpuscle {
namespace {

AirbagSample row_of(const gas::GasState& state, const gas::PartState& parts) {
    AirbagSample row;
    row.volume = state.volume;
    row.pressure = state.pressure;
    row.temperature = state.temperature;
    row.mass = state.mass;
    row.mass_in = state.mass_in;
    row.mass_out_vent = state.mass_out_vent;
    row.mass_out_fabric = state.mass_out_fabric;
    row.particles_out = state.particles_out;
    row.energy = state.energy;
    row.translational_energy = state.translational;
    row.surface_area = state.area;
    for (const auto& share : state.species)
        row.species.push_back({share.mass, share.temperature, share.energy});
    for (std::size_t p = 0; p < parts.pressure.size(); ++p)
        row.parts.push_back({parts.pressure[p], parts.area[p], parts.mass_out[p], parts.heat[p]});
    return row;
}

/// @param done  share of the last load that velocities at t hold                      [-]
AirbagSample sample_of(gas::BagGas& bag, const Points& x, double since, double done) {
    AirbagSample row = row_of(bag.state(x), bag.part_state(x, since));
    for (const gas::ChamberState& now : bag.chamber_states(x))
        row.chambers.push_back({now.volume, now.pressure, now.temperature, now.mass, now.energy});
    row.particles = static_cast<double>(bag.particles().size());
    const gas::Wrench owed = bag.owed(done);
    row.owed_momentum = owed.linear;
    row.owed_angular_momentum = owed.angular;
    row.mass_rate_in = bag.mass_rate_in(since);
    row.mass_rate_out = bag.mass_rate_out(since);
    return row;
}

AirbagSample sample_of(const gas::UniformBag& bag, const Points& x) {
    AirbagSample row = row_of(bag.state(x), bag.part_state(x));
    row.mass_out_vent = bag.mass_out();
    row.mass_rate_in = bag.rate_in();
    row.mass_rate_out = bag.rate_out();
    return row;
}

}  // namespace

RecordLayout Simulation::layout() const {
    RecordLayout layout;
    for (const gas::BagGas& bag : bags_) {
        RecordLayout::Airbag entry;
        entry.id = bag.card().id;
        entry.has_initial_air = bag.card().air.has_value();
        if (entry.has_initial_air) entry.species.push_back(0);
        for (std::size_t s = 0; s < bag.card().inflow.size(); ++s)
            entry.species.push_back(static_cast<int>(s) + 1);
        entry.parts = bag.walls().part_ids;
        for (const gas::ChamberCard& chamber : bag.card().chambers)
            entry.chambers.push_back(chamber.id);
        layout.airbags.push_back(std::move(entry));
    }
    for (const gas::UniformBag& bag : uniform_bags_)
        layout.airbags.push_back({.id = bag.card().id,
                                  .species = {1},
                                  .parts = bag.walls().part_ids,
                                  .has_particles = false});
    layout.sensors = model_.sensors.size();
    for (const Part& part : model_.parts) layout.parts.push_back(part.id);
    layout.part_mass.resize(model_.parts.size());
    for (std::size_t s = 0; s < model_.shells.size(); ++s)
        layout.part_mass[model_.shells[s].part] += shell_mass_[s];
    for (const RigidBody& body : bodies_) {
        layout.rigid_bodies.push_back(model_.parts[body.part()].id);
        for (const Index part : body.parts()) layout.part_mass[part] = 0.0;  // the lead has all
        layout.part_mass[body.part()] = body.mass();
    }
    for (const auto& wall : model_.walls) {
        layout.walls.push_back(wall.id);
        layout.wall_normals.push_back(contact::plane_normal(wall.shape));
        if (!wall.motion.direction.isZero(0.0)) layout.moving_walls.push_back(wall.id);
    }
    for (const auto& contact : model_.contacts) layout.contacts.push_back(contact.id);
    for (const RigidJoints& joints : joints_) layout.joints = joints.ids();
    for (const Index node : model_.history_nodes) {
        layout.history_nodes.push_back(model_.node_id[node]);
        layout.history_node_rows.push_back(node);
    }
    layout.node_id = model_.node_id;
    layout.coordinates = model_.x;
    for (const Shell& shell : model_.shells) {
        layout.shell_id.push_back(shell.id);
        layout.shell_part.push_back(model_.parts[shell.part].id);
        layout.shell_nodes.push_back(shell.nodes);
    }
    return layout;
}

Vec3 Simulation::force_on(const RigidBody& body) const {
    Vec3 force = body.impulse_force();
    for (const Index n : body.nodes()) force += gas_force(n);
    return force;
}

Sample Simulation::sample() {
    Sample row;
    row.time = clock_.t;
    row.dt = clock_.dt_last;
    row.step = clock_.step;
    row.energy = books();
    const double since = clock_.t - last_sample_;
    last_sample_ = clock_.t;
    for (gas::BagGas& bag : bags_)
        row.airbags.push_back(sample_of(bag, nodes_.x, since, ledger_.weight));
    for (const gas::UniformBag& bag : uniform_bags_)
        row.airbags.push_back(sample_of(bag, nodes_.x));

    row.parts.resize(model_.parts.size());
    for (std::size_t s = 0; s < model_.shells.size(); ++s) {
        const Shell& shell = model_.shells[s];
        const int corners = shell.is_triangle() ? 3 : 4;
        for (int c = 0; c < corners; ++c) {
            const Vec3 v = velocity(shell.nodes[c]);
            const double mass = shell_mass_[s] / corners;
            row.parts[shell.part].kinetic_energy += 0.5 * mass * v.squaredNorm();
            row.parts[shell.part].momentum += mass * v;
        }
    }
    for (const fabric::Membranes& fabric : fabric_) {
        const std::span<const double> strain = fabric.part_strain_energy();
        for (std::size_t p = 0; p < strain.size(); ++p) row.parts[p].strain_energy += strain[p];
    }
    for (const RigidBody& body : bodies_) {
        const Vec3 velocity = body.velocity_at_t(ledger_.weight);
        row.rigid_bodies.push_back(
            {body.position(), velocity, body.acceleration(), force_on(body)});
        for (const Index part : body.parts()) row.parts[part] = {};
        row.parts[body.part()].kinetic_energy = body.kinetic_energy_at_t(ledger_.weight);
        row.parts[body.part()].momentum = body.mass() * velocity;
    }
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        const contact::RigidWall& wall = walls_[w];
        row.wall_impulse.push_back(wall_impulses_.given(w, ledger_.weight));
        if (wall.moves())
            row.moving_walls.push_back({wall.displacement(), wall.velocity_at_t(ledger_.weight)});
    }
    for (std::size_t c = 0; c < model_.contacts.size(); ++c) {
        const int card = static_cast<int>(c);
        const auto depth = contacts_[0].depth(card);
        row.contacts.push_back({contact_impulses_.given(c, ledger_.weight),
                                contacts_[0].energy_of(card), static_cast<double>(depth.pairs),
                                depth.greatest});
    }
    for (std::size_t j = 0; j < joint_impulses_.size(); ++j)
        row.joints.push_back(
            {joint_impulses_.given(j, ledger_.weight), joint_turnings_.given(j, ledger_.weight)});
    row.sensors.resize(model_.sensors.size());
    parallel::for_each(
        row.sensors.size(),
        [&](std::size_t s) {
            const gas::SensorReading now = gas::read(model_.sensors[s], bags_, nodes_.x);
            row.sensors[s] = {now.particles, now.pressure, now.temperature,
                              now.density,   now.velocity, now.centre};
        },
        /*chunk=*/1);
    for (const Index node : model_.history_nodes) {
        row.node_coordinates.push_back(nodes_.x[node]);
        row.node_velocity.push_back(velocity(node));
    }
    return row;
}

/// Of shells without contact 0.
void Simulation::find_contact_pressure(std::vector<float>& pressure) {
    for (contact::SurfaceContact& contact : contacts_) {
        const std::vector<double> force = contact.take_facet_forces(nodes_.x);
        std::vector<double> on_shell(model_.shells.size(), 0.0);
        for (std::size_t t = 0; t < force.size(); ++t) on_shell[contact_shell_[t]] += force[t];
        for (std::size_t s = 0; s < on_shell.size(); ++s) {
            const auto& n = model_.shells[s].nodes;
            const Points& x = nodes_.x;
            const double area = vector_area(x[n[0]], x[n[1]], x[n[2]]).norm() +
                                vector_area(x[n[0]], x[n[2]], x[n[3]]).norm();
            pressure.push_back(area > 0.0 ? static_cast<float>(on_shell[s] / area) : 0.0F);
        }
    }
}

Frame Simulation::frame() {
    Frame state;
    state.time = clock_.t;
    state.coordinates = nodes_.x;
    state.velocity.resize(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        state.velocity[n] = velocity(static_cast<Index>(n));
    const std::size_t shells = model_.shells.size();
    state.shell_active.assign(shells, 1);
    state.shell_stress.assign(shells, {0.0F, 0.0F, 0.0F});
    state.shell_strain.assign(shells, {0.0F, 0.0F, 0.0F});
    for (const fabric::Membranes& fabric : fabric_)
        fabric.stress_strain(nodes_.x, state.shell_stress, state.shell_strain);

    std::vector<double> force(shells, 0.0), area(shells, 0.0);
    const double since = clock_.t - last_frame_;
    last_frame_ = clock_.t;
    for (gas::BagGas& bag : bags_) bag.add_shell_load(nodes_.x, since, force, area);
    for (const gas::UniformBag& bag : uniform_bags_) bag.add_shell_load(nodes_.x, force, area);
    state.shell_pressure.resize(shells);
    for (std::size_t s = 0; s < shells; ++s)
        state.shell_pressure[s] = area[s] > 0.0 ? static_cast<float>(force[s] / area[s]) : 0.0F;

    find_contact_pressure(state.shell_contact_pressure);
    for (const gas::BagGas& bag : bags_) {
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
    return state;
}

}  // namespace corpuscle
