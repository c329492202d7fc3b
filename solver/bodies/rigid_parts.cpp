// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/rigid_parts.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace corpuscle {
namespace {

/// Of a mass at a place r from where moments are taken.
Mat3 moved_inertia(double mass, const Vec3& r) {
    return mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

/// Mass, centre and inertia of nodes, in ascending order.
RigidInertia inertia_of(const Model& model, const std::vector<Index>& nodes,
                        const std::vector<double>& node_mass) {
    const Points& x = model.x;
    RigidInertia all;
    all.mass = 0.0;
    for (const Index n : nodes) {
        all.mass += node_mass[n];
        all.centre += node_mass[n] * x[n];
    }
    if (!(all.mass > 0.0)) return all;
    all.centre /= all.mass;
    for (const Index n : nodes) all.inertia += moved_inertia(node_mass[n], x[n] - all.centre);
    for (const NodeInertia& own : model.node_inertias)
        if (std::binary_search(nodes.begin(), nodes.end(), own.node)) all.inertia += own.inertia;
    return all;
}

/// What *PART_INERTIA or solids say of a part, or nullptr.
const RigidInertia* card_of(const Model& model, Index part) {
    for (const RigidInertia& inertia : model.rigid_inertia)
        if (inertia.part == part) return &inertia;
    return nullptr;
}

/// The merge by which a part is in its lead's *PART_INERTIA, or nullptr.
const RigidMerge* merge_into_lead(const Model& model, Index part) {
    for (const RigidMerge& merge : model.rigid_merges)
        if (merge.part == part && merge.keeps_inertia && card_of(model, merge.lead) != nullptr)
            return &merge;
    return nullptr;
}

/// The part whose *PART_INERTIA has a part's mass; -1: its nodes have it.
Index speaker_of(const Model& model, Index part) {
    for (const RigidMerge* merge = merge_into_lead(model, part); merge != nullptr;
         merge = merge_into_lead(model, part))
        part = merge->lead;
    return card_of(model, part) != nullptr ? part : -1;
}

/// Of two bodies that move as one, the first of which has mass.
RigidInertia merged(const RigidInertia& a, const RigidInertia& b) {
    RigidInertia all;
    all.mass = a.mass + b.mass;
    all.centre = (a.mass * a.centre + b.mass * b.centre) / all.mass;
    all.inertia = a.inertia + b.inertia + moved_inertia(a.mass, a.centre - all.centre) +
                  moved_inertia(b.mass, b.centre - all.centre);
    return all;
}

}  // namespace

bool is_rigid(const Model& model, Index part) {
    const Index material = model.parts[part].material;
    return material >= 0 &&
           std::holds_alternative<fabric::RigidCard>(model.materials[material].card);
}

std::vector<Index> merged_parts(const Model& model, Index lead) {
    std::vector<Index> parts = {lead};
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (const RigidMerge& merge : model.rigid_merges)
            if (merge.lead == parts[k]) parts.push_back(merge.part);
    return parts;
}

std::vector<Index> nodes_of_rigid_parts(const Model& model, const std::vector<Index>& parts) {
    const auto is_of = [&](Index part) {
        return std::find(parts.begin(), parts.end(), part) != parts.end();
    };
    std::vector<Index> nodes;
    for (const Shell& shell : model.shells)
        if (is_of(shell.part)) nodes.insert(nodes.end(), shell.nodes.begin(), shell.nodes.end());
    for (const RigidExtraNode& extra : model.rigid_extra_nodes)
        if (is_of(extra.part)) nodes.push_back(extra.node);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

std::vector<Index> parts_of_nodes(const Model& model, const std::vector<Index>& parts) {
    std::vector<Index> own;
    for (const Index part : parts)
        if (speaker_of(model, part) < 0) own.push_back(part);
    return own;
}

RigidInertia inertia_of_parts(const Model& model, const std::vector<Index>& parts,
                              const std::vector<double>& node_mass) {
    std::vector<RigidInertia> bodies;
    for (const Index part : parts)
        if (const RigidInertia* inertia = card_of(model, part);
            inertia != nullptr && merge_into_lead(model, part) == nullptr)
            bodies.push_back(*inertia);
    const std::vector<Index> others = parts_of_nodes(model, parts);
    if (!others.empty())
        bodies.push_back(inertia_of(model, nodes_of_rigid_parts(model, others), node_mass));
    RigidInertia all = bodies.front();
    for (std::size_t k = 1; k < bodies.size(); ++k) all = merged(all, bodies[k]);
    return all;
}

std::vector<double> mass_shares(const Model& model, const std::vector<Index>& parts,
                                const std::vector<double>& node_mass) {
    struct Group {
        double by_nodes = 0.0;  ///< mass of its nodes, each of them once                    [kg]
        std::set<Index> nodes;
        Index first = -1;  ///< part
    };
    std::map<Index, Group> groups;  // by who speaks for their mass
    std::vector<double> own(parts.size(), 0.0);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        Group& group = groups[speaker_of(model, parts[k])];
        if (group.first < 0) group.first = parts[k];
        for (const Index n : nodes_of_rigid_parts(model, {parts[k]}))
            if (group.nodes.insert(n).second) own[k] += node_mass[n];
        group.by_nodes += own[k];
    }
    const auto mass_of = [&](Index speaker, const Group& group) {
        return speaker < 0 ? group.by_nodes : card_of(model, speaker)->mass;
    };
    double all = 0.0;
    for (const auto& [speaker, group] : groups) all += mass_of(speaker, group);
    for (std::size_t k = 0; k < parts.size(); ++k) {
        const Index speaker = speaker_of(model, parts[k]);
        const Group& group = groups.at(speaker);
        const double of_group = group.by_nodes > 0.0 ? own[k] / group.by_nodes
                                                     : static_cast<double>(parts[k] == group.first);
        own[k] = all > 0.0 ? mass_of(speaker, group) / all * of_group : k == 0 ? 1.0 : 0.0;
    }
    return own;
}

}  // namespace corpuscle
