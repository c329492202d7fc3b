// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a scene needs, worked out once.

#include "solver/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "solver/base/error.hpp"
#include "solver/reference_geometry.hpp"
#include "solver/scene_surface.hpp"

namespace corpuscle {
namespace {

/// Part of the step that all others allow to which contact may shorten it where it is pressed hard.
constexpr double LEAST_HELD = 0.25;

std::vector<bool> marked(const std::vector<Index>& parts, std::size_t count) {
    std::vector<bool> mark(count, false);
    for (const Index part : parts) mark[part] = true;
    return mark;
}

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

double contact_thickness(const Part& part) {
    return std::isnan(part.contact_thickness) ? part.thickness : part.contact_thickness;
}

/// Numbers the parts that the walls' shells belong to.
void number_parts(const Model& model, gas::BagWalls& walls) {
    std::vector<Index> row(model.parts.size(), -1);
    for (const Index shell : walls.shell) {
        const Index part = model.shells[shell].part;
        if (row[part] < 0) {
            row[part] = static_cast<Index>(walls.part_ids.size());
            walls.part_ids.push_back(model.parts[part].id);
        }
        walls.part.push_back(row[part]);
    }
}

gas::BagWalls bag_walls(const Model& model, const gas::UniformBagCard& card) {
    std::vector<bool> wanted(model.shells.size(), false);
    for (const Index shell : card.shells) wanted[shell] = true;
    SceneTriangles all = triangles_of(model, std::vector<bool>(model.parts.size(), true));
    gas::BagWalls walls;
    for (std::size_t t = 0; t < all.triangles.size(); ++t) {
        if (!wanted[all.shell[t]]) continue;
        walls.triangles.push_back(all.triangles[t]);
        walls.shell.push_back(all.shell[t]);
    }
    walls.closing = walls.triangles.size();
    number_parts(model, walls);
    return walls;
}

/// What the fabric of a part says of leaking, if it does.
std::optional<gas::LeakCard> leak_of(const Model& model, Index part) {
    const auto* cloth =
        std::get_if<fabric::FabricCard>(&model.materials[model.parts[part].material].card);
    if (cloth == nullptr || !cloth->leaks()) return {};
    return gas::LeakCard{part,
                         cloth->leak_area,
                         cloth->leak_area_curve,
                         cloth->leak_velocity,
                         cloth->leak_velocity_curve,
                         cloth->leak_by_component,
                         cloth->leak_when_blocked,
                         cloth->leak_from_reference,
                         cloth->leak_growth};
}

gas::BagWalls bag_walls(const Model& model, const gas::BagCard& card,
                        const std::vector<std::array<Vec3, 4>>& reference) {
    const std::size_t count = model.parts.size();
    gas::BagWalls walls;
    SceneTriangles closing = triangles_of(model, marked(card.external_parts, count));
    const SceneTriangles internal = triangles_of(model, marked(card.internal_parts, count));
    walls.closing = closing.triangles.size();
    walls.triangles = std::move(closing.triangles);
    walls.shell = std::move(closing.shell);
    walls.triangles.insert(walls.triangles.end(), internal.triangles.begin(),
                           internal.triangles.end());
    walls.shell.insert(walls.shell.end(), internal.shell.begin(), internal.shell.end());

    std::vector<Index> row(count, -1);
    for (const auto* parts : {&card.external_parts, &card.internal_parts})
        for (const Index part : *parts) {
            row[part] = static_cast<Index>(walls.part_ids.size());
            walls.part_ids.push_back(model.parts[part].id);
            walls.part_rows.push_back(part);
            if (const auto leak = leak_of(model, part)) walls.leaks.push_back(*leak);
        }
    for (const Index shell : walls.shell) walls.part.push_back(row[model.shells[shell].part]);
    walls.reference_area.assign(walls.part_ids.size(), 0.0);
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        if (row[model.shells[s].part] < 0) continue;
        const auto& [a, b, c, d] = reference[s];
        walls.reference_area[row[model.shells[s].part]] +=
            vector_area(a, b, c).norm() + vector_area(a, c, d).norm();
    }
    return walls;
}

}  // namespace

Simulation::Simulation(Model model, std::uint64_t seed)
    : model_(std::move(model)), seed_(seed), supports_(model_), loads_(model_) {
    const std::size_t count = model_.x.size();
    if (model_.velocity.empty()) model_.velocity.assign(count, Vec3::Zero());
    nodes_ = {model_.x, model_.x, model_.velocity, Points(count, Vec3::Zero()), {}};
    v_before_ = v_mid_ = nodes_.v;

    build_fabric();
    build_bodies();
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
}

void Simulation::build_bodies() {
    std::vector<std::string> faults;
    for (std::size_t p = 0; p < model_.parts.size(); ++p) {
        const auto part = static_cast<Index>(p);
        const bool used = std::any_of(model_.shells.begin(), model_.shells.end(),
                                      [&](const Shell& s) { return s.part == part; });
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
}

/// 1 for nodes that supports, motions or rigid bodies carry in every direction.
std::vector<std::uint8_t> Simulation::held_nodes() const {
    std::vector<std::uint8_t> held(model_.x.size(), 0);
    for (std::size_t n = 0; n < held.size(); ++n) held[n] = supports_.held()[n] == 7;
    for (const RigidBody& body : bodies_)
        for (const Index node : body.nodes()) held[node] = 1;
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
    if (!faults.empty()) throw InputError(std::move(faults));
}

/// One contact for all cards: what may touch by any of them.
void Simulation::build_contacts() {
    if (model_.contacts.empty()) return;
    std::vector<std::uint8_t> held = held_nodes();
    std::vector<Index> body(model_.x.size(), -1);
    for (std::size_t b = 0; b < bodies_.size(); ++b)
        for (const Index n : bodies_[b].nodes()) {
            body[n] = static_cast<Index>(b);
            held[n] = 0;
        }
    std::vector<bool> wanted(model_.parts.size(), false);
    for (const contact::ContactCard& card : model_.contacts)
        for (const auto* parts : {&card.parts, &card.other_parts})
            for (const Index part : *parts) wanted[part] = true;
    SceneTriangles facets = triangles_of(model_, wanted);
    Points reference = model_.x;
    for (std::size_t s = 0; s < reference_.size(); ++s)
        for (int c = 0; c < 4; ++c) reference[model_.shells[s].nodes[c]] = reference_[s][c];

    contact::ContactSetup setup;
    setup.cards = model_.contacts;
    setup.triangles = std::move(facets.triangles);
    for (const Index shell : facets.shell) {
        const Index part = model_.shells[shell].part;
        setup.part.push_back(part);
        setup.thickness.push_back(contact_thickness(model_.parts[part]));
    }
    setup.parts = model_.parts.size();
    setup.node_mass = nodes_.mass;
    setup.reference_x = reference;
    setup.x0 = model_.x;
    setup.curves = model_.curves;
    setup.held = held;
    setup.body = body;
    contact_shell_ = std::move(facets.shell);
    contacts_.emplace_back(setup);
    contact_force_.f.assign(model_.x.size(), Vec3::Zero());
}

void Simulation::build_walls() {
    const std::vector<std::uint8_t> held = held_nodes();
    for (contact::WallCard card : model_.walls) {
        const std::size_t listed = card.nodes.size();
        const auto has_body = [&](Index n) {
            return !body_of_node_.empty() && body_of_node_[n] >= 0;
        };
        std::erase_if(card.nodes, [&](Index n) { return held[n] && !has_body(n); });
        if (card.nodes.size() < listed)
            model_.warnings.push_back(
                fmt::format("*RIGIDWALL {}: {} of its nodes are held and pass it freely", card.id,
                            listed - card.nodes.size()));
        std::erase_if(card.nodes, [&](Index n) { return !(nodes_.mass[n] > 0.0) && !has_body(n); });
        const Index curve = card.motion.curve;
        walls_.emplace_back(card, curve >= 0 ? &model_.curves[curve] : nullptr);
    }
}

void Simulation::look_at_contacts() {
    for (std::size_t b = 0; b < bodies_.size(); ++b) movers_[b] = bodies_[b].mover();
    for (contact::SurfaceContact& contact : contacts_)
        contact.find(nodes_.x, nodes_.v, clock_.t, stable_step().dt, movers_);
}

Simulation::BadStarts Simulation::bad_starts() const {
    BadStarts out;
    const auto ids = [&](const auto& pairs, auto& to) {
        for (const auto& [a, b] : pairs) {
            const int first = model_.shells[contact_shell_[a]].id,
                      second = model_.shells[contact_shell_[b]].id;
            if (first != second) to.emplace_back(std::minmax(first, second));
        }
        std::sort(to.begin(), to.end());
        to.erase(std::unique(to.begin(), to.end()), to.end());
    };
    for (const contact::SurfaceContact& contact : contacts_) {
        ids(contact.crossing(), out.crossing);
        ids(contact.close_starts(), out.close);
    }
    return out;
}

std::size_t Simulation::particles() const {
    std::size_t count = 0;
    for (const gas::BagGas& bag : bags_) count += bag.particles().size();
    return count;
}

StepLimit Simulation::stable_step() const {
    StepLimit limit;
    for (const fabric::Membranes& fabric : fabric_) {
        const auto [dt, shell] = fabric.stable_step();
        if (shell >= 0)
            limit.tighten(model_.step_factor * dt, StepLimit::Who::SHELL, model_.shells[shell].id);
    }
    for (const gas::BagGas& bag : bags_)
        limit.tighten(bag.stable_step(), StepLimit::Who::GAS, bag.card().id);
    for (const gas::UniformBag& bag : uniform_bags_)
        limit.tighten(bag.stable_step(), StepLimit::Who::GAS, bag.card().id);
    // Rigid bodies alone set no limit: a thousand steps are what a path wants to be seen.
    if (limit.who == StepLimit::Who::NOTHING) limit.dt = model_.end_time / 1000.0;
    const double least = LEAST_HELD * limit.dt;
    for (const contact::SurfaceContact& contact : contacts_)
        if (const double dt = std::max(contact.holding_step(), least); dt < limit.dt)
            limit.tighten(dt, StepLimit::Who::CONTACT, model_.contacts[contact.pressed_card()].id);
    for (const contact::SurfaceContact& contact : contacts_)
        if (const double dt = contact.stable_step(nodes_.v); dt < limit.dt)
            limit.tighten(dt, StepLimit::Who::CONTACT,
                          model_.contacts[contact.limiting_card(nodes_.v)].id);
    if (clock_.step == 0 && model_.step_start > 0.0)
        limit.tighten(model_.step_start, StepLimit::Who::START, 0);
    const double rest = model_.end_time - clock_.t;
    if (limit.dt >= rest * (1.0 - 1e-9)) return {rest, StepLimit::Who::END, 0};
    if (2.0 * limit.dt > rest)
        limit.dt = 0.5 * rest;  // two like steps, not a last one that is tiny
    return limit;
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
