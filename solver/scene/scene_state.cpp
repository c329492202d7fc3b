// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a scene needs, worked out once.

#include "solver/scene/scene_state.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gas/particles.hpp"
#include "solver/base/error.hpp"
#include "solver/bodies/rigid_parts.hpp"
#include "solver/scene/bag_walls.hpp"
#include "solver/scene/held_ties.hpp"
#include "solver/scene/reference_geometry.hpp"

namespace corpuscle {
namespace {

bool is_null(const Model& model, Index part) {
    return std::holds_alternative<fabric::NullCard>(
        model.materials[model.parts[part].material].card);
}

/// Shells that are strained: neither rigid nor of null material, and with a node that supports do
/// not keep where it is; what drives all its nodes may strain it.
std::vector<std::uint8_t> strained_shells(const Model& model) {
    std::vector<std::uint8_t> fixed(model.x.size(), 0), active(model.shells.size(), 0);
    for (const Support& support : model.supports)
        fixed[support.node] |= static_cast<std::uint8_t>(support.fixed & 7U);
    for (std::size_t s = 0; s < active.size(); ++s) {
        const Shell& shell = model.shells[s];
        if (is_rigid(model, shell.part) || is_null(model, shell.part)) continue;
        active[s] = std::any_of(shell.nodes.begin(), shell.nodes.end(),
                                [&](Index n) { return fixed[n] != 7; });
    }
    return active;
}

}  // namespace

SceneState::SceneState(Model of, std::uint64_t draw)
    : model(std::move(of)), seed(draw), supports(model), ties(model), loads(model) {
    part_coinciding_cloth();
    const std::size_t count = model.x.size();
    if (model.velocity.empty()) model.velocity.assign(count, Vec3::Zero());
    nodes = {model.x, model.x, model.velocity, Points(count, Vec3::Zero()), {}};
    v.before = v.mid = nodes.v;

    build_cloth();
    build_bodies();
    check_ties();
    if (cloth.active_shells > 0) cloth.growth = GrowthMonitor(fabric_nodes(), fabric_sizes());
    build_bags();
    build_contacts();
    build_walls();
    if (!loads.empty()) forces.loads.f.assign(count, Vec3::Zero());
    if (model.mass_damping != 0.0 || model.mass_damping_curve >= 0 || !model.part_dampings.empty())
        forces.damping.f.assign(count, Vec3::Zero());
    ledger.before.kinetic = ledger.after.kinetic = kinetic_energy();
}

void SceneState::build_cloth() {
    cloth.active = strained_shells(model);
    cloth.reference = reference_corners(model);
    cloth.births = reference_births(model);
    cloth.next_birth = next_birth(0.0, cloth.births);
    check_births(model, cloth.births);
    fabric::MembraneSetup setup{model.shells, model.parts,    model.materials, cloth.reference,
                                cloth.active, model.x.size(), model.curves,    model.x};
    nodes.mass = fabric::lumped_mass(setup);
    for (const NodeMass& added : model.node_masses) nodes.mass[added.node] += added.mass;
    cloth.shell_mass = fabric::shell_mass(setup);
    find_damped_mass();
    loads.share_mass(model, cloth.shell_mass, ties);
    cloth.active_shells =
        static_cast<std::size_t>(std::count(cloth.active.begin(), cloth.active.end(), 1));
    if (cloth.active_shells > 0) cloth.membranes = membranes_now();
    if (cloth.membranes)
        for (const auto& [part, inner, sewn] : cloth.membranes->coat().parts())
            if (sewn > 0)
                model.warnings.push_back(fmt::format(
                    "part {}: its coat bends at {} of {} inner nodes; at the others the reference "
                    "shape has a seam, or is bent by more than {:.2g} degrees along an edge",
                    model.parts[part].id, inner - sewn, inner,
                    fabric::CoatBending::SEAM * 180.0 / std::numbers::pi));
    using Scaling = fabric::Membranes::Scaling;
    if (cloth.membranes && model.step_mass_scaled != 0.0) {
        const auto added = cloth.membranes->scale_mass(
            std::abs(model.step_mass_scaled),
            model.step_mass_scaled < 0.0 ? Scaling::WHERE_NEEDED : Scaling::EVERYWHERE);
        for (std::size_t n = 0; n < nodes.size(); ++n) nodes.mass[n] += added.node[n];
        cloth.added_mass = added.total;
    }
    if (cloth.membranes &&
        is_strained(model, cloth.active,
                    corners_before(cloth.next_birth, cloth.births, cloth.reference, model),
                    StrainedStart::LITTLE))
        cloth.strained_start.begin(cloth.membranes->stable_step().dt);
    if (ties.empty()) return;
    ties.share_momentum(nodes.mass, nodes.v);
    ties.share_mass(nodes.mass);
    ties.hold(nodes.v);
}

/// Nodes of rigid bodies ride on these alone, and tied nodes on their edges' ends.
void SceneState::check_ties() {
    if (ties.empty()) return;
    const HeldTies holds(model);
    std::vector<std::string> faults;
    for (const TiedNode& tie : ties.all()) {
        const bool is_of_body = !bodies.of_node.empty() && bodies.of_node[tie.node] >= 0;
        if (!is_of_body && !holds.is_lost(tie)) continue;
        faults.push_back(fmt::format(
            "node {} is tied to nodes {} and {} and {}", model.node_id[tie.node],
            model.node_id[tie.ends[0]], model.node_id[tie.ends[1]],
            is_of_body ? "of a rigid part, expected one of the two"
                       : "held or moved as these are not: it goes where they go, expected the "
                         "same support or motion on both of them, or none on it"));
    }
    if (!faults.empty()) throw InputError(std::move(faults));
    met_mass = ties.met_mass(nodes.mass);
}

/// 1 for nodes that supports, motions, rigid bodies or other nodes carry in every direction.
std::vector<std::uint8_t> SceneState::held_nodes() const {
    std::vector<std::uint8_t> held(model.x.size(), 0);
    for (std::size_t n = 0; n < held.size(); ++n) held[n] = supports.held()[n] == 7;
    for (const RigidBody& body : bodies.all)
        for (const Index node : body.nodes()) held[node] = 1;
    for (const TiedNode& tie : ties.all()) held[tie.node] = 1;
    return held;
}

std::vector<Index> SceneState::turning_bodies() const {
    std::vector<Index> body = bodies.of_node;
    if (body.empty()) return body;
    for (Index& b : body)
        if (b >= 0 && !bodies.all[b].can_turn()) b = -1;
    for (auto tie = ties.all().rbegin(); tie != ties.all().rend(); ++tie)
        if (body[tie->ends[0]] == body[tie->ends[1]]) body[tie->node] = body[tie->ends[0]];
    if (std::all_of(body.begin(), body.end(), [](Index b) { return b < 0; })) body.clear();
    return body;
}

namespace {

std::string name_of(const gas::BagCard& card) {
    return card.name();
}
std::string name_of(const gas::UniformBagCard& card) {
    return fmt::format("{} {}", card.keyword, card.id);
}

/// Facets that were turned are a mending, or a fault where a bag is taken as it is.
void take_turned(std::size_t turned, const std::string& bag, Model& model,
                 std::vector<Fault>& faults) {
    if (turned == 0) return;
    if (!model.closes_bags)
        faults.push_back({.of = bag,
                          .property = Property::CLOSING_WALL,
                          .why = fmt::format("{} facets have their normals against their "
                                             "neighbours', expected all on one side",
                                             turned)});
    else
        model.mendings.push_back(fmt::format("{}: {} facets turned", bag, turned));
}

/// Of a bag's random numbers: no two bags of a run share any; the first has the run's own seed.
std::uint64_t seed_of_bag(std::uint64_t seed, std::size_t bag) {
    constexpr std::uint64_t FAR = 0x9E3779B97F4A7C15;  // 2^64 over the golden ratio
    return seed + FAR * static_cast<std::uint64_t>(bag);
}

/// Facets that are no wall of the gas are a mending.
gas::BagWalls with_pairs_told(gas::BagWalls walls, const std::string& bag, Model& model) {
    if (walls.empty_pairs > 0)
        model.mendings.push_back(
            fmt::format("{}: {} pair{} of facets with all nodes in common enclose{} nothing and "
                        "{} no wall of its gas",
                        bag, walls.empty_pairs, walls.empty_pairs == 1 ? "" : "s",
                        walls.empty_pairs == 1 ? "s" : "", walls.empty_pairs == 1 ? "is" : "are"));
    return walls;
}

}  // namespace

void SceneState::build_bags() {
    std::vector<Fault> faults;
    const auto build = [&](auto& bags, auto&&... how) {
        try {
            const auto& bag = bags.emplace_back(how...);
            const auto& found = bag.warnings();
            model.warnings.insert(model.warnings.end(), found.begin(), found.end());
            take_turned(bag.enclosure().turned(), name_of(bag.card()), model, faults);
        } catch (const InputError& error) {
            faults.insert(faults.end(), error.typed.begin(), error.typed.end());
        }
    };
    for (std::size_t b = 0; b < model.bags.size(); ++b) {
        const gas::BagCard& card = model.bags[b];
        build(airbags.particle, card,
              with_pairs_told(bag_walls(model, card, cloth.reference), name_of(card), model),
              model.curves, model.node_id, held_nodes(), model.x, seed_of_bag(seed, b),
              turning_bodies());
    }
    for (const gas::UniformBagCard& card : model.uniform_bags)
        build(airbags.uniform, card, with_pairs_told(bag_walls(model, card), name_of(card), model),
              model.curves, model.node_id, model.x);
    for (const gas::ExchangeCard& card : model.exchanges)
        airbags.exchanges.emplace_back(card, model.curves);
    if (!faults.empty()) throw InputError(std::move(faults));
}

std::size_t SceneState::particles() const {
    std::size_t count = 0;
    for (const gas::BagGas& bag : airbags.particle) count += bag.particles().size();
    return count;
}

}  // namespace corpuscle
