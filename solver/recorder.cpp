// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// One row of every history. Frames: record_frame.cpp.

#include "solver/recorder.hpp"

#include "gas/particles.hpp"
#include "solver/base/parallel.hpp"
#include "solver/energy/energy_audit.hpp"

namespace corpuscle {
namespace {

/// visit(part, node, mass) for what each shell gives to each of its nodes, but for nodes of rigid
/// bodies: these have it.
template <class Visit>
void each_share(const SceneState& scene, Visit&& visit) {
    const std::vector<Index>& body = scene.bodies.of_node;
    for (std::size_t s = 0; s < scene.model.shells.size(); ++s) {
        const Shell& shell = scene.model.shells[s];
        const int corners = shell.is_triangle() ? 3 : 4;
        for (int c = 0; c < corners; ++c)
            if (body.empty() || body[shell.nodes[c]] < 0)
                visit(shell.part, shell.nodes[c], scene.cloth.shell_mass[s] / corners);
    }
}

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
    row.static_pressure = state.static_pressure;
    row.static_temperature = state.static_temperature;
    for (const auto& share : state.species)
        row.species.push_back({share.mass, share.temperature, share.energy});
    for (std::size_t p = 0; p < parts.pressure.size(); ++p)
        row.parts.push_back({parts.pressure[p], parts.area[p], parts.mass_out[p], parts.heat[p]});
    return row;
}

/// @param done  share of the last load that velocities at t hold                      [-]
AirbagSample sample_of(const gas::BagGas& bag, const gas::PartState& parts, const Points& x,
                       double done) {
    AirbagSample row = row_of(bag.state(x), parts);
    for (const gas::ChamberState& now : bag.chamber_states(x))
        row.chambers.push_back({now.volume, now.pressure, now.temperature, now.mass, now.energy,
                                now.static_pressure, now.static_temperature});
    row.particles = static_cast<double>(bag.particles().size());
    const gas::Wrench owed = bag.owed(done);
    row.owed_momentum = owed.linear;
    row.owed_angular_momentum = owed.angular;
    return row;
}

AirbagSample sample_of(const gas::UniformBag& bag, const Points& x) {
    AirbagSample row = row_of(bag.state(x), bag.part_state(x));
    row.mass_out_vent = bag.mass_out();
    row.mass_rate_in = bag.rate_in();
    row.mass_rate_out = bag.rate_out();
    return row;
}

void add_airbags(const SceneState& scene, RecordLayout& layout) {
    for (const gas::BagGas& bag : scene.airbags.particle) {
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
    for (const gas::UniformBag& bag : scene.airbags.uniform)
        layout.airbags.push_back({.id = bag.card().id,
                                  .species = {1},
                                  .parts = bag.walls().part_ids,
                                  .has_particles = false});
}

void add_bodies(const SceneState& scene, RecordLayout& layout) {
    layout.sensors = scene.model.sensors.size();
    for (const Part& part : scene.model.parts) layout.parts.push_back(part.id);
    layout.part_mass.resize(scene.model.parts.size());
    each_share(scene, [&](Index part, Index, double mass) { layout.part_mass[part] += mass; });
    for (const RigidBody& body : scene.bodies.all) {
        layout.rigid_bodies.push_back(scene.model.parts[body.part()].id);
        for (const Index part : body.parts()) layout.part_mass[part] = 0.0;  // the lead has all
        layout.part_mass[body.part()] = body.mass();
    }
    for (const auto& wall : scene.model.walls) {
        layout.walls.push_back(wall.id);
        layout.wall_normals.push_back(contact::plane_normal(wall.shape));
        if (!wall.motion.direction.isZero(0.0)) layout.moving_walls.push_back(wall.id);
    }
    for (const auto& contact : scene.model.contacts) layout.contacts.push_back(contact.id);
    if (scene.bodies.joints) layout.joints = scene.bodies.joints->ids();
    for (const Index node : scene.model.history_nodes) {
        layout.history_nodes.push_back(scene.model.node_id[node]);
        layout.history_node_rows.push_back(node);
    }
}

void add_parts(const SceneState& scene, Sample& row) {
    row.parts.resize(scene.model.parts.size());
    each_share(scene, [&](Index part, Index node, double mass) {
        const Vec3 v = scene.velocity(node);
        row.parts[part].kinetic_energy += 0.5 * mass * v.squaredNorm();
        row.parts[part].momentum += mass * v;
    });
    if (scene.cloth.membranes) {
        const std::span<const double> strain = scene.cloth.membranes->part_strain_energy();
        for (std::size_t p = 0; p < strain.size(); ++p) row.parts[p].strain_energy += strain[p];
    }
}

void add_bodies(const SceneState& scene, Sample& row) {
    for (const RigidBody& body : scene.bodies.all) {
        const Vec3 velocity = body.velocity_at_t(scene.ledger.weight);
        row.rigid_bodies.push_back({body.position(), velocity, body.acceleration(),
                                    Recorder::force_on(scene, body),
                                    body.angular_momentum_at_t(scene.ledger.weight)});
        for (const Index part : body.parts()) row.parts[part] = {};
        row.parts[body.part()].kinetic_energy = body.kinetic_energy_at_t(scene.ledger.weight);
        row.parts[body.part()].momentum = body.mass() * velocity;
    }
}

void add_obstacles(const SceneState& scene, Sample& row) {
    for (std::size_t w = 0; w < scene.obstacles.walls.size(); ++w) {
        const contact::RigidWall& wall = scene.obstacles.walls[w];
        row.wall_impulse.push_back(scene.impulses.walls.given(w, scene.ledger.weight));
        if (wall.moves())
            row.moving_walls.push_back(
                {wall.displacement(), wall.velocity_at_t(scene.ledger.weight)});
    }
    for (std::size_t c = 0; c < scene.model.contacts.size(); ++c) {
        const int card = static_cast<int>(c);
        const auto depth = scene.obstacles.contact->depth(card);
        row.contacts.push_back({scene.impulses.contacts.given(c, scene.ledger.weight),
                                scene.obstacles.contact->energy_of(card),
                                static_cast<double>(depth.pairs), depth.greatest});
    }
    for (std::size_t j = 0; j < scene.impulses.joints.size(); ++j)
        row.joints.push_back({scene.impulses.joints.given(j, scene.ledger.weight),
                              scene.impulses.turnings.given(j, scene.ledger.weight)});
}

void add_sensors(const SceneState& scene, Sample& row) {
    row.sensors.resize(scene.model.sensors.size());
    if (row.sensors.empty()) return;
    const gas::ParticleRuns runs(scene.airbags.particle);
    parallel::for_each(
        row.sensors.size(),
        [&](std::size_t s) {
            const gas::SensorReading now =
                gas::read(scene.model.sensors[s], scene.airbags.particle, runs, scene.nodes.x);
            row.sensors[s] = {now.particles, now.pressure, now.temperature,
                              now.density,   now.velocity, now.centre};
        },
        /*chunk=*/1);
}

}  // namespace

RecordLayout Recorder::layout(const SceneState& scene) {
    RecordLayout layout;
    add_airbags(scene, layout);
    add_bodies(scene, layout);
    layout.node_id = scene.model.node_id;
    layout.coordinates = scene.model.x;
    for (const Shell& shell : scene.model.shells) {
        layout.shell_id.push_back(shell.id);
        layout.shell_part.push_back(scene.model.parts[shell.part].id);
        layout.shell_nodes.push_back(shell.nodes);
    }
    return layout;
}

Vec3 Recorder::force_on(const SceneState& scene, const RigidBody& body) {
    Vec3 force = body.impulse_force();
    for (const Index n : body.nodes()) force += scene.gas_force(n);
    return force;
}

Sample Recorder::sample(SceneState& scene) {
    std::vector<gas::PartState> parts;
    const double since = scene.clock.t - last_sample_;
    last_sample_ = scene.clock.t;
    for (gas::BagGas& bag : scene.airbags.particle)
        parts.push_back(bag.part_state(scene.nodes.x, since));
    return row_at_t(scene, parts);
}

Sample Recorder::glance(const SceneState& scene) const {
    std::vector<gas::PartState> parts;
    const double since = scene.clock.t - last_sample_;
    for (const gas::BagGas& bag : scene.airbags.particle)
        parts.push_back(bag.part_state_so_far(scene.nodes.x, since));
    return row_at_t(scene, parts);
}

Sample Recorder::row_at_t(const SceneState& scene, std::span<const gas::PartState> parts) {
    Sample row;
    row.time = scene.clock.t;
    row.dt = scene.clock.dt_last;
    row.step = scene.clock.step;
    row.energy = EnergyAudit::books(scene);
    for (std::size_t b = 0; b < parts.size(); ++b)
        row.airbags.push_back(
            sample_of(scene.airbags.particle[b], parts[b], scene.nodes.x, scene.ledger.weight));
    for (const gas::UniformBag& bag : scene.airbags.uniform)
        row.airbags.push_back(sample_of(bag, scene.nodes.x));
    add_parts(scene, row);
    add_bodies(scene, row);
    add_obstacles(scene, row);
    add_sensors(scene, row);
    for (const Index node : scene.model.history_nodes) {
        row.node_coordinates.push_back(scene.nodes.x[node]);
        row.node_velocity.push_back(scene.velocity(node));
    }
    return row;
}

}  // namespace corpuscle
