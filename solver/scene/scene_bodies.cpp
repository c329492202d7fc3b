// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rigid bodies of a scene, and the cloth that rides on them.

#include <fmt/format.h>

#include <algorithm>

#include "solver/base/error.hpp"
#include "solver/bodies/rigid_parts.hpp"
#include "solver/bodies/rigid_start.hpp"
#include "solver/scene/scene_state.hpp"

namespace corpuscle {
namespace {

/// Velocities at the start that joints do not allow are made to agree in this share of the run, as
/// by a blow; and what of kinetic energy may go unsaid.
constexpr double BLOW = 1e-6, AGREE = 1e-9;

}  // namespace

void SceneState::build_bodies() {
    std::vector<std::string> faults;
    start_rigid_parts(model, nodes.mass, nodes.v);
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const auto part = static_cast<Index>(p);
        const bool used =
            std::any_of(model.shells.begin(), model.shells.end(),
                        [&](const Shell& s) { return s.part == part; }) ||
            std::any_of(model.rigid_extra_nodes.begin(), model.rigid_extra_nodes.end(),
                        [&](const RigidExtraNode& n) { return n.part == part; });
        const bool is_led = std::any_of(model.rigid_merges.begin(), model.rigid_merges.end(),
                                        [&](const RigidMerge& m) { return m.part == part; });
        if (used && !is_led && is_rigid(model, part))
            bodies.all.emplace_back(model, part, nodes.mass);
    }
    bodies.riding = riding_cloth(model, bodies.all, cloth.shell_mass, ties, nodes.mass);
    loads.ride(bodies.riding, bodies.all);
    share_part_damping();
    std::vector<const RigidBody*> owner(nodes.size(), nullptr);
    for (const RigidBody& body : bodies.all)
        for (const Index n : body.nodes()) {
            if (owner[n] != nullptr)
                faults.push_back(fmt::format("node {} belongs to rigid parts {} and {}",
                                             model.node_id[n], model.parts[owner[n]->part()].id,
                                             model.parts[body.part()].id));
            owner[n] = &body;
            nodes.mass[n] = 0.0;  // the body has it
        }
    if (!faults.empty()) throw InputError(std::move(faults));
    bodies.proxies.resize(bodies.all.size());
    if (bodies.all.empty()) return;
    bodies.of_node.assign(nodes.size(), -1);
    for (std::size_t b = 0; b < bodies.all.size(); ++b)
        for (const Index n : bodies.all[b].nodes()) bodies.of_node[n] = static_cast<Index>(b);
    if (!model.rigid_joints.empty()) join_bodies();
    if (!model.joint_stiffnesses.empty()) bodies.springs.emplace(model, bodies.all);
}

/// Of bodies, by the mass of their rigid parts that are damped; cloth that rides on them has its own.
void SceneState::share_part_damping() {
    if (model.part_dampings.empty()) return;
    std::vector<double> rigid_mass = nodes.mass;
    for (const RidingNode& riding : bodies.riding) rigid_mass[riding.node] -= riding.by_shells;
    for (const RigidBody& body : bodies.all) {
        const std::vector<double> shares = mass_shares(model, body.parts(), rigid_mass);
        bodies.damped.emplace_back(model.part_dampings.size(), 0.0);
        for (std::size_t k = 0; k < model.part_dampings.size(); ++k)
            for (std::size_t p = 0; p < shares.size(); ++p)
                if (body.parts()[p] == model.part_dampings[k].part)
                    bodies.damped.back()[k] += shares[p];
    }
}

/// Velocities at the start that joints do not allow are made to agree.
void SceneState::join_bodies() {
    bodies.joints.emplace(model, bodies.all);
    const double before = kinetic_energy(), blow = BLOW * model.end_time;
    for (std::size_t b = 0; b < bodies.all.size(); ++b) {
        bodies.proxies[b] = bodies.all[b].proxy();
        bodies.all[b].foresee(blow);
    }
    bodies.joints->hold(0.0, blow, 0.0, RigidJoints::After::CONTACT, bodies.all, bodies.proxies,
                        nodes);
    for (RigidBody& body : bodies.all) body.foresee(0.0);  // they have not moved
    impulses.joints = impulses.turnings = ImpulseBook(bodies.joints->take_given().size());
    if (const double taken = before - kinetic_energy(); taken > AGREE * before)
        model.warnings.push_back(fmt::format(
            "velocities at the start pull joints of rigid parts apart: they are made to agree, "
            "which takes {:.3g} of {:.3g} of kinetic energy",
            taken, before));
}

}  // namespace corpuscle
