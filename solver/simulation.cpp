// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a scene needs, worked out once.

#include "solver/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"
#include "solver/scene/bag_walls.hpp"
#include "solver/scene/reference_geometry.hpp"

namespace corpuscle {
namespace {

/// Velocities at the start that joints do not allow are made to agree in this share of the run, as
/// by a blow; and what of kinetic energy may go unsaid.
constexpr double BLOW = 1e-6, AGREE = 1e-9;

bool is_rigid(const Model& model, Index part) {
    return std::holds_alternative<fabric::RigidCard>(
        model.materials[model.parts[part].material].card);
}

bool is_null(const Model& model, Index part) {
    return std::holds_alternative<fabric::NullCard>(
        model.materials[model.parts[part].material].card);
}

/// Shells that are strained: neither rigid nor of null material, and with a node that is free to
/// move.
std::vector<std::uint8_t> strained_shells(const Model& model, const Constraints& supports) {
    std::vector<std::uint8_t> active(model.shells.size(), 0);
    for (std::size_t s = 0; s < active.size(); ++s) {
        const Shell& shell = model.shells[s];
        if (is_rigid(model, shell.part) || is_null(model, shell.part)) continue;
        active[s] = std::any_of(shell.nodes.begin(), shell.nodes.end(),
                                [&](Index n) { return supports.held()[n] != 7; });
    }
    return active;
}

}  // namespace

Simulation::Simulation(Model model, std::uint64_t seed)
    : model_(std::move(model)), seed_(seed), supports_(model_), ties_(model_), loads_(model_) {
    part_coinciding_cloth();
    const std::size_t count = model_.x.size();
    if (model_.velocity.empty()) model_.velocity.assign(count, Vec3::Zero());
    nodes_ = {model_.x, model_.x, model_.velocity, Points(count, Vec3::Zero()), {}};
    v_before_ = v_mid_ = nodes_.v;

    build_fabric();
    build_bodies();
    check_ties();
    if (active_shells_ > 0) growth_ = GrowthMonitor(fabric_nodes(), fabric_sizes());
    build_bags(seed);
    build_contacts();
    build_walls();
    if (!loads_.empty()) load_force_.f.assign(count, Vec3::Zero());
    if (model_.mass_damping != 0.0 || model_.mass_damping_curve >= 0)
        damping_force_.f.assign(count, Vec3::Zero());
    ledger_.before.kinetic = ledger_.after.kinetic = kinetic_energy();
}

void Simulation::build_fabric() {
    active_ = strained_shells(model_, supports_);
    reference_ = reference_corners(model_);
    births_ = reference_births(model_);
    next_birth_ = next_birth(0.0, births_);
    check_births(model_, births_);
    fabric::MembraneSetup setup{model_.shells, model_.parts,    model_.materials, reference_,
                                active_,       model_.x.size(), model_.curves,    model_.x};
    nodes_.mass = fabric::lumped_mass(setup);
    shell_mass_ = fabric::shell_mass(setup);
    loads_.share_mass(model_, shell_mass_);
    active_shells_ = static_cast<std::size_t>(std::count(active_.begin(), active_.end(), 1));
    if (active_shells_ > 0) fabric_.push_back(membranes_at(0.0));
    for (const fabric::Membranes& fabric : fabric_)
        for (const auto& [part, inner, sewn] : fabric.coat().parts())
            if (sewn > 0)
                model_.warnings.push_back(fmt::format(
                    "part {}: its coat bends at {} of {} inner nodes; at the others the reference "
                    "shape has a seam, or is bent by more than {:.2g} degrees along an edge",
                    model_.parts[part].id, inner - sewn, inner,
                    fabric::CoatBending::SEAM * 180.0 / std::numbers::pi));
    using Scaling = fabric::Membranes::Scaling;
    for (fabric::Membranes& fabric : fabric_) {
        if (model_.step_mass_scaled == 0.0) break;
        const auto added = fabric.scale_mass(
            std::abs(model_.step_mass_scaled),
            model_.step_mass_scaled < 0.0 ? Scaling::WHERE_NEEDED : Scaling::EVERYWHERE);
        for (std::size_t n = 0; n < nodes_.size(); ++n) nodes_.mass[n] += added.node[n];
        added_mass_ = added.total;
    }
    if (ties_.empty()) return;
    ties_.share_mass(nodes_.mass);
    ties_.hold(nodes_.v);
}

void Simulation::build_bodies() {
    std::vector<std::string> faults;
    for (std::size_t p = 0; p < model_.parts.size(); ++p) {
        const auto part = static_cast<Index>(p);
        const bool used =
            std::any_of(model_.shells.begin(), model_.shells.end(),
                        [&](const Shell& s) { return s.part == part; }) ||
            std::any_of(model_.rigid_extra_nodes.begin(), model_.rigid_extra_nodes.end(),
                        [&](const RigidExtraNode& n) { return n.part == part; });
        const bool is_led = std::any_of(model_.rigid_merges.begin(), model_.rigid_merges.end(),
                                        [&](const RigidMerge& m) { return m.part == part; });
        if (used && !is_led && is_rigid(model_, part))
            bodies_.emplace_back(model_, part, nodes_.mass);
    }
    std::vector<const RigidBody*> owner(nodes_.size(), nullptr);
    for (const RigidBody& body : bodies_)
        for (const Index n : body.nodes()) {
            if (owner[n] != nullptr)
                faults.push_back(fmt::format("node {} belongs to rigid parts {} and {}",
                                             model_.node_id[n], model_.parts[owner[n]->part()].id,
                                             model_.parts[body.part()].id));
            owner[n] = &body;
            nodes_.mass[n] = 0.0;  // the body has it
        }
    if (!faults.empty()) throw InputError(std::move(faults));
    movers_.resize(bodies_.size());
    if (bodies_.empty()) return;
    body_of_node_.assign(nodes_.size(), -1);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (const Index n : bodies_[b].nodes()) body_of_node_[n] = static_cast<Index>(b);
    if (model_.rigid_joints.empty()) return;
    joints_.emplace_back(model_, bodies_);
    const double before = kinetic_energy(), blow = BLOW * model_.end_time;
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
        movers_[b] = bodies_[b].mover();
        bodies_[b].foresee(blow);
    }
    joints_[0].hold(0.0, blow, 0.0, RigidJoints::After::CONTACT, bodies_, movers_, nodes_);
    for (RigidBody& body : bodies_) body.foresee(0.0);  // they have not moved
    joint_impulses_ = joint_turnings_ = ImpulseBook(joints_[0].take_given().size());
    if (const double taken = before - kinetic_energy(); taken > AGREE * before)
        model_.warnings.push_back(fmt::format(
            "velocities at the start pull joints of rigid parts apart: they are made to agree, "
            "which takes {:.3g} of {:.3g} of kinetic energy",
            taken, before));
}

/// Nodes of rigid bodies ride on these alone.
void Simulation::check_ties() {
    for (const TiedNode& tie : ties_.all())
        if (!body_of_node_.empty() && body_of_node_[tie.node] >= 0)
            throw InputError(fmt::format(
                "node {} is tied to nodes {} and {} and of a rigid part, expected one of the two",
                model_.node_id[tie.node], model_.node_id[tie.ends[0]],
                model_.node_id[tie.ends[1]]));
    if (!ties_.empty()) met_mass_ = ties_.met_mass(nodes_.mass);
}

/// 1 for nodes that supports, motions, rigid bodies or other nodes carry in every direction.
std::vector<std::uint8_t> Simulation::held_nodes() const {
    std::vector<std::uint8_t> held(model_.x.size(), 0);
    for (std::size_t n = 0; n < held.size(); ++n) held[n] = supports_.held()[n] == 7;
    for (const RigidBody& body : bodies_)
        for (const Index node : body.nodes()) held[node] = 1;
    for (const TiedNode& tie : ties_.all()) held[tie.node] = 1;
    return held;
}

void Simulation::build_bags(std::uint64_t seed) {
    std::vector<std::string> faults;
    const auto build = [&](auto& bags, auto&&... how) {
        try {
            const auto& found = bags.emplace_back(how...).warnings();
            model_.warnings.insert(model_.warnings.end(), found.begin(), found.end());
        } catch (const InputError& error) {
            faults.insert(faults.end(), error.faults.begin(), error.faults.end());
        }
    };
    for (const gas::BagCard& card : model_.bags)
        build(bags_, card, bag_walls(model_, card, reference_), model_.curves, model_.node_id,
              held_nodes(), model_.x, seed);
    for (const gas::UniformBagCard& card : model_.uniform_bags)
        build(uniform_bags_, card, bag_walls(model_, card), model_.curves, model_.node_id,
              model_.x);
    for (const gas::ExchangeCard& card : model_.exchanges)
        exchanges_.emplace_back(card, model_.curves);
    if (!faults.empty()) throw InputError(std::move(faults));
}

std::size_t Simulation::particles() const {
    std::size_t count = 0;
    for (const gas::BagGas& bag : bags_) count += bag.particles().size();
    return count;
}

void Simulation::close(const Observer& observe) {
    Stopwatch lap(timings_);
    const double dt = clock_.dt_last;
    find_forces(dt, dt, lap);
    kick(dt, dt);
    stop_at_obstacles(dt);
    book_forces(dt);
    observe(*this);
}

}  // namespace corpuscle
