// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/rigid_parts.hpp"

#include <algorithm>

namespace corpuscle {
namespace {

/// Of a mass at a place r from where moments are taken.
Mat3 moved_inertia(double mass, const Vec3& r) {
    return mass * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
}

/// Mass, centre and inertia of nodes.
RigidInertia inertia_of(const Points& x, const std::vector<Index>& nodes,
                        const std::vector<double>& node_mass) {
    RigidInertia all;
    all.mass = 0.0;
    for (const Index n : nodes) {
        all.mass += node_mass[n];
        all.centre += node_mass[n] * x[n];
    }
    if (!(all.mass > 0.0)) return all;
    all.centre /= all.mass;
    for (const Index n : nodes) all.inertia += moved_inertia(node_mass[n], x[n] - all.centre);
    return all;
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

RigidInertia inertia_of_parts(const Model& model, const std::vector<Index>& parts,
                              const std::vector<double>& node_mass) {
    const auto given = [&](Index part) -> const RigidInertia* {
        for (const RigidInertia& inertia : model.rigid_inertia)
            if (inertia.part == part) return &inertia;
        return nullptr;
    };
    const auto is_in_its_leads = [&](Index part) {
        return std::any_of(
            model.rigid_merges.begin(), model.rigid_merges.end(), [&](const RigidMerge& merge) {
                return merge.part == part && merge.keeps_inertia && given(merge.lead) != nullptr;
            });
    };
    std::vector<RigidInertia> bodies;
    std::vector<Index> others;
    for (const Index part : parts) {
        if (is_in_its_leads(part)) continue;
        if (const RigidInertia* inertia = given(part))
            bodies.push_back(*inertia);
        else
            others.push_back(part);
    }
    if (!others.empty())
        bodies.push_back(inertia_of(model.x, nodes_of_rigid_parts(model, others), node_mass));
    RigidInertia all = bodies.front();
    for (std::size_t k = 1; k < bodies.size(); ++k) all = merged(all, bodies[k]);
    return all;
}

}  // namespace corpuscle
