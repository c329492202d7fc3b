// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/loose_ends.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/model/held_bodies.hpp"
#include "io/model/merged_loads.hpp"
#include "io/model/motion_check.hpp"
#include "io/model/part_remarks.hpp"

namespace corpuscle::io {
namespace {

using keywords::is_rigid;

std::string name_of(const Draft& draft, Index part) {
    const Part& p = draft.model.parts[static_cast<std::size_t>(part)];
    return p.title.empty() ? fmt::format("part {}", p.id)
                           : fmt::format("part {} \"{}\"", p.id, p.title);
}

/// Shells and solids of each part.
std::vector<std::size_t> elements_of_parts(const Draft& draft) {
    std::vector<std::size_t> count(draft.model.parts.size(), 0);
    for (const Shell& shell : draft.model.shells)
        if (shell.part >= 0) ++count[static_cast<std::size_t>(shell.part)];
    for (const Solid& solid : draft.solid)
        if (solid.part >= 0) ++count[static_cast<std::size_t>(solid.part)];
    return count;
}

/// The material of parts that nothing is of.
Index no_material(Model& model) {
    model.materials.push_back({0, "none", fabric::NullCard{1.0}});
    return static_cast<Index>(model.materials.size()) - 1;
}

}  // namespace

Place place_of(const Draft& draft, Index part) {
    const Registry::Entry* entry =
        draft.parts.find(draft.model.parts[static_cast<std::size_t>(part)].id);
    return entry != nullptr ? entry->place : Place{};
}

void check_parts(Draft& draft, Faults& faults) {
    Model& model = draft.model;
    const std::vector<std::size_t> elements = elements_of_parts(draft);
    Index none = -1;
    for (std::size_t p = 0; p < model.parts.size(); ++p) {
        const auto row = static_cast<Index>(p);
        Part& part = model.parts[p];
        const auto bare = draft.bare_parts.find(row);
        if (elements[p] > 0 && bare != draft.bare_parts.end()) {
            faults.fault(bare->second.place,
                         fmt::format("*PART {} has {} = 0 and {} elements, expected the id of a "
                                     "*{} of the deck",
                                     part.id, bare->second.keyword, elements[p],
                                     bare->second.keyword == "MID" ? "MAT" : "SECTION"));
            continue;
        }
        const auto unread = draft.unread_materials.find(part.material);
        if (elements[p] > 0 && unread != draft.unread_materials.end())
            faults.fault(unread->second.place,
                         fmt::format("*{} is not supported yet, and {} elements of {} are of it",
                                     unread->second.keyword, elements[p], name_of(draft, row)));
        if (elements[p] > 0 && draft.part_section[p] >= 0) {
            const Section& section = draft.section[static_cast<std::size_t>(draft.part_section[p])];
            if (!section.other.empty())
                faults.fault(place_of(draft, row),
                             fmt::format("*PART {} has a *{} and {} shells or solids, expected a "
                                         "*SECTION_SHELL or *SECTION_SOLID",
                                         part.id, section.other, elements[p]));
        }
        if (bare == draft.bare_parts.end() || part.material >= 0) continue;
        if (none < 0) none = no_material(model);
        part.material = none;
    }
    check_forms(draft, faults);
}

namespace {

/// 1 for nodes of shells that deform, or have mass alone.
std::vector<std::uint8_t> cloth_nodes(const Draft& draft) {
    std::vector<std::uint8_t> is_cloth(draft.model.x.size(), 0);
    for (const Shell& shell : draft.model.shells)
        if (shell.part >= 0 && !is_rigid(draft, shell.part))
            for (const Index node : shell.nodes)
                if (node >= 0) is_cloth[static_cast<std::size_t>(node)] = 1;
    return is_cloth;
}

void leave_out_links(Draft& draft, Faults& faults) {
    const std::vector<std::uint8_t> is_cloth = cloth_nodes(draft);
    struct Group {
        const Link* first = nullptr;  ///< of those that hold cloth, else of all
        std::size_t count = 0, holding = 0;
        Index held = -1;  ///< node of cloth
    };
    std::map<std::pair<std::string, Index>, Group> groups;
    for (const Link& link : draft.links) {
        Group& group = groups[{link.keyword, link.part}];
        if (group.first == nullptr) group.first = &link;
        ++group.count;
        for (const Index node : link.nodes)
            if (is_cloth[static_cast<std::size_t>(node)] != 0) {
                if (group.held < 0) {
                    group.first = &link;
                    group.held = node;
                }
                ++group.holding;
                break;
            }
    }
    for (const auto& [of, group] : groups) {
        const std::string what =
            fmt::format("*{}: {} elements of {}", of.first, group.count, name_of(draft, of.second));
        if (group.held >= 0)
            faults.fault(
                group.first->place,
                fmt::format("{}, {} of which hold cloth (first at node {}), are not acted on, "
                            "expected rigid ones, or none at the cloth",
                            what, group.holding,
                            draft.model.node_id[static_cast<std::size_t>(group.held)]));
        else
            faults.warn(group.first->place,
                        fmt::format("{} are left out: they deform, and hold no cloth; what they "
                                    "join moves without them",
                                    what));
    }
}

/// Bodies of nodes that nothing with mass is at hold nothing.
void leave_out_empty_bodies(Draft& draft, Faults& faults) {
    Model& model = draft.model;
    const std::vector<std::uint8_t> has_mass = nodes_with_mass(model);
    std::map<Index, bool> has;  // part -> some node has mass
    for (const RigidExtraNode& extra : model.rigid_extra_nodes)
        has[extra.part] |= has_mass[static_cast<std::size_t>(extra.node)] != 0;
    for (const RigidInertia& body : model.rigid_inertia) has[body.part] = true;
    for (const Shell& shell : model.shells)
        if (shell.part >= 0) has[shell.part] = true;
    for (const RigidMerge& merge : model.rigid_merges) has[merge.part] = has[merge.lead] = true;
    for (const auto& [part, is_there] : has) {
        if (is_there) continue;
        faults.warn(place_of(draft, part),
                    fmt::format("{} is left out: nothing that has mass is at its nodes",
                                name_of(draft, part)));
        std::erase_if(model.rigid_extra_nodes,
                      [&, p = part](const RigidExtraNode& extra) { return extra.part == p; });
    }
}

/// Supports of a node of solids that are taken as rigid hold the body.
void hold_stiffened(Draft& draft, Faults& faults) {
    Model& model = draft.model;
    const std::vector<std::uint8_t> is_cloth = cloth_nodes(draft);
    for (const Index part : draft.stiffened_parts) {
        std::vector<std::uint8_t> is_own(model.x.size(), 0);
        for (const Solid& solid : draft.solid)
            if (solid.part == part)
                for (const Index node : solid.nodes) is_own[static_cast<std::size_t>(node)] = 1;
        for (std::size_t n = 0; n < is_own.size(); ++n)
            if (is_own[n] != 0 && is_cloth[n] != 0) {
                faults.fault(
                    place_of(draft, part),
                    fmt::format("*PART {}: its solids deform and hold cloth at node {}, "
                                "expected *MAT_RIGID for solids at cloth",
                                model.parts[static_cast<std::size_t>(part)].id, model.node_id[n]));
                break;
            }
        DofMask held = 0;
        std::size_t nodes = 0;
        for (const Support& support : model.supports)
            if (support.node >= 0 && is_own[static_cast<std::size_t>(support.node)] != 0 &&
                (support.fixed & 7U) != 0) {
                held |= support.fixed & 7U;
                ++nodes;
            }
        std::erase_if(model.supports, [&](const Support& support) {
            return support.node >= 0 && is_own[static_cast<std::size_t>(support.node)] != 0;
        });
        const Index material = model.parts[static_cast<std::size_t>(part)].material;
        auto& rigid =
            std::get<fabric::RigidCard>(model.materials[static_cast<std::size_t>(material)].card);
        rigid.fixed_moves = held;
        rigid.fixed_turns = nodes > 1 ? 7U : 0U;
    }
}

void check_leaks_count(const Draft& draft, Faults& faults) {
    std::vector<std::uint8_t> closes(draft.model.parts.size(), 0);
    for (const gas::BagCard& bag : draft.model.bags)
        for (const auto* parts : {&bag.external_parts, &bag.internal_parts})
            for (const Index part : *parts) closes[static_cast<std::size_t>(part)] = 1;
    for (const gas::UniformBagCard& bag : draft.model.uniform_bags)
        for (const Index shell : bag.shells) {
            const Index part = draft.model.shells[static_cast<std::size_t>(shell)].part;
            if (part >= 0) closes[static_cast<std::size_t>(part)] = 1;
        }
    for (const auto& [material, place] : draft.added_leaks) {
        bool counts = false;
        for (std::size_t p = 0; p < closes.size(); ++p)
            counts |= closes[p] != 0 && draft.model.parts[p].material == material;
        if (!counts)
            faults.warn(place,
                        fmt::format("*MAT_ADD_AIRBAG_POROSITY_LEAKAGE does not count: no "
                                    "part of material {} closes a bag",
                                    draft.model.materials[static_cast<std::size_t>(material)].id));
    }
}

/// What acts on a rigid part needs a body: shells, or nodes that ride on it or on those merged.
void check_bodies(const Draft& draft, Faults& faults) {
    const Model& model = draft.model;
    std::vector<std::uint8_t> has_body(model.parts.size(), 0);  // by lead
    const auto mark = [&](Index part) {
        if (part >= 0) has_body[static_cast<std::size_t>(keywords::lead_of(draft, part))] = 1;
    };
    for (const Shell& shell : model.shells) mark(shell.part);
    for (const RigidExtraNode& extra : model.rigid_extra_nodes) mark(extra.part);
    for (const auto& [part, place] : draft.body_uses)
        if (has_body[static_cast<std::size_t>(keywords::lead_of(draft, part))] == 0)
            faults.fault(place, fmt::format("{} has no elements and no nodes, expected a rigid "
                                            "part that has some",
                                            name_of(draft, part)));
}

/// Nodes do not turn, but bodies do.
void check_inertias(Draft& draft, Faults& faults) {
    const std::vector<Index>& owner = keywords::rigid_owners(draft);
    for (std::size_t k = 0; k < draft.node_inertias_at.size(); ++k) {
        const auto node = static_cast<std::size_t>(draft.model.node_inertias[k].node);
        if (owner[node] < 0)
            faults.fault(draft.node_inertias_at[k],
                         fmt::format("*ELEMENT_INERTIA gives a tensor to node {}, expected a node "
                                     "of a rigid part: others do not turn",
                                     draft.model.node_id[node]));
    }
}

}  // namespace

void settle_loose_ends(Draft& draft, Faults& faults) {
    leave_out_links(draft, faults);
    leave_out_empty_bodies(draft, faults);
    hold_stiffened(draft, faults);
    hold_bodies(draft, faults);
    check_motions(draft, faults);
    check_curves(draft, faults);
    check_leaks_count(draft, faults);
    check_merged_loads(draft, faults);
    check_inertias(draft, faults);
    check_bodies(draft, faults);
    expect_extent(draft, faults);
    warn_of_lost_masses(draft, faults);
    note_stopped_bodies(draft, faults);
}

}  // namespace corpuscle::io
