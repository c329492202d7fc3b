// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/part_remarks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <variant>
#include <vector>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/model/loose_ends.hpp"

namespace corpuscle::io {
namespace {

/// Parts whose shells have strains.
std::set<Index> parts_that_deform(const Model& model) {
    std::set<Index> parts;
    for (const Shell& shell : model.shells) {
        if (shell.part < 0) continue;
        const Index material = model.parts[static_cast<std::size_t>(shell.part)].material;
        if (material < 0) continue;
        const auto& card = model.materials[static_cast<std::size_t>(material)].card;
        if (std::holds_alternative<fabric::FabricCard>(card) ||
            std::holds_alternative<fabric::ElasticCard>(card))
            parts.insert(shell.part);
    }
    return parts;
}

/// Parts whose mass and inertia are said, not summed up from nodes.
std::set<Index> parts_of_said_mass(const Model& model) {
    std::set<Index> parts;
    for (const RigidInertia& said : model.rigid_inertia) parts.insert(said.part);
    for (const RigidMerge& merge : model.rigid_merges)
        if (merge.keeps_inertia && parts.contains(merge.lead)) parts.insert(merge.part);
    return parts;
}

}  // namespace

void check_forms(const Draft& draft, Faults& faults) {
    std::map<Index, std::vector<int>> parts_of;  // by section
    for (const Index part : parts_that_deform(draft.model)) {
        const Index section = draft.part_section[static_cast<std::size_t>(part)];
        if (section >= 0)
            parts_of[section].push_back(draft.model.parts[static_cast<std::size_t>(part)].id);
    }
    for (const auto& [row, parts] : parts_of) {
        const Section& section = draft.section[static_cast<std::size_t>(row)];
        const int form = section.element_form;
        if (!section.other.empty() || section.is_solid || form == 5 || form == 9) continue;
        const std::string which = fmt::format(
                              "*{}, field 2 (ELFORM) = {}",
                              section.is_composite ? "PART_COMPOSITE" : "SECTION_SHELL", form),
                          whose = fmt::format(" (part{} {})", parts.size() > 1 ? "s" : "",
                                              fmt::join(parts, ", "));
        if ((form >= 12 && form <= 15) || form > 40 || form == 23 || form == 24)
            faults.fault(
                section.place,
                which + ", expected a membrane, 5 or 9, or a thin shell of 3 or 4 nodes" + whose);
        else
            faults.warn(section.place, which +
                                           ": this shell is taken as a membrane: only a coat bends "
                                           "(ECOAT, TCOAT of *MAT_FABRIC)" +
                                           whose);
    }
}

std::vector<std::uint8_t> nodes_with_mass(const Model& model) {
    std::vector<std::uint8_t> has_mass(model.x.size(), 0);
    for (const Shell& shell : model.shells)
        for (const Index node : shell.nodes)
            if (node >= 0) has_mass[static_cast<std::size_t>(node)] = 1;
    for (const NodeMass& added : model.node_masses)
        if (added.mass > 0.0) has_mass[static_cast<std::size_t>(added.node)] = 1;
    return has_mass;
}

namespace {

/// Parts that have a moment of inertia whatever nodes ride on them.
std::set<Index> parts_with_inertia(const Model& model) {
    std::set<Index> parts;
    for (const Shell& shell : model.shells) parts.insert(shell.part);
    for (const RigidInertia& said : model.rigid_inertia) parts.insert(said.part);
    for (const RigidMerge& merge : model.rigid_merges) parts.insert({merge.part, merge.lead});
    for (const RigidExtraNode& extra : model.rigid_extra_nodes)
        for (const NodeInertia& own : model.node_inertias)
            if (own.node == extra.node) parts.insert(extra.part);
    return parts;
}

}  // namespace

void expect_extent(const Draft& draft, Faults& faults) {
    constexpr double ONE_PLACE = 1e-9;  // of the coordinates
    const Model& model = draft.model;
    const std::vector<std::uint8_t> has_mass = nodes_with_mass(model);
    const std::set<Index> extended = parts_with_inertia(model);
    std::map<Index, Eigen::AlignedBox3d> boxes;
    for (const auto& [part, node] : model.rigid_extra_nodes)
        if (!extended.contains(part) && has_mass[static_cast<std::size_t>(node)] != 0)
            boxes[part].extend(model.x[static_cast<std::size_t>(node)]);
    for (const auto& [part, box] : boxes)
        if (box.diagonal().norm() <= ONE_PLACE * box.center().norm())
            faults.fault(place_of(draft, part),
                         fmt::format("rigid part {} has all of its mass in one place, expected "
                                     "nodes with mass in several, or a tensor (_INERTIA, "
                                     "*ELEMENT_INERTIA): it has no moment of inertia",
                                     model.parts[static_cast<std::size_t>(part)].id));
}

void warn_of_lost_masses(const Draft& draft, Faults& faults) {
    const Model& model = draft.model;
    if (model.node_masses.empty()) return;
    const std::set<Index> said = parts_of_said_mass(model);
    std::set<Index> nodes;
    for (const Shell& shell : model.shells)
        if (said.contains(shell.part)) nodes.insert(shell.nodes.begin(), shell.nodes.end());
    for (const RigidExtraNode& extra : model.rigid_extra_nodes)
        if (said.contains(extra.part)) nodes.insert(extra.node);
    std::size_t count = 0;
    double mass = 0.0;
    for (const NodeMass& added : model.node_masses) {
        if (!nodes.contains(added.node)) continue;
        ++count;
        mass += added.mass;
    }
    if (count > 0)
        faults.warn(
            draft.node_masses_at,
            fmt::format(
                "*ELEMENT_MASS or _INERTIA: {} masses, {:g} in all, are on nodes of rigid parts "
                "whose mass *PART_INERTIA says: they count for nothing",
                count, mass));
}

void note_stopped_bodies(Draft& draft, Faults& faults) {
    if (draft.rigid_wall_penalty != 0.0) return;
    const std::vector<Index>& owner = keywords::rigid_owners(draft);
    for (const Numbered& named : draft.numbered) {
        if (named.kind != Numbered::Kind::WALL) continue;
        const contact::WallCard& wall = draft.model.walls[named.row];
        const auto count = std::count_if(wall.nodes.begin(), wall.nodes.end(), [&](Index node) {
            return owner[static_cast<std::size_t>(node)] >= 0;
        });
        if (count > 0)
            faults.note(named.place,
                        fmt::format("*{} {} stops {} nodes of rigid bodies too; with RWPNAL = 0 or "
                                    "blank in *CONTROL_CONTACT LS-DYNA lets them pass",
                                    named.keyword, wall.id, count));
    }
}

}  // namespace corpuscle::io
