// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Nodes that move as one body, or with other nodes.

#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/bodies/held.hpp"
#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

/// A part of its own for nodes that are held rigidly together; none of them has a shell in it.
Index add_body(Draft& draft, int id, const std::string& title) {
    Model& model = draft.model;
    Part part;
    part.id = id;
    part.title = title;
    part.material = static_cast<Index>(model.materials.size());
    part.thickness = 0.0;
    fabric::RigidCard rigid;
    rigid.density = rigid.E = 1.0;
    model.materials.push_back({0, title, rigid});
    draft.part_has_solids.push_back(0);
    draft.part_section.push_back(-1);
    model.parts.push_back(part);
    return static_cast<Index>(model.parts.size()) - 1;
}

/// Nodes of rigid parts keep to them: the new body is merged with these, and they with each other.
void join(Cards& cards, Draft& draft, Index body, const std::vector<Index>& nodes) {
    Model& model = draft.model;
    const std::vector<Index>& owner = rigid_owners(draft);
    std::vector<Index> owners;
    for (const Index node : nodes) {
        const Index own = owner[static_cast<std::size_t>(node)];
        if (own < 0)
            model.rigid_extra_nodes.push_back({body, node});
        else if (own != body && std::find(owners.begin(), owners.end(), own) == owners.end())
            owners.push_back(own);
    }
    draft.rigid_owner.clear();
    if (owners.empty()) return;
    const auto id = [&](Index part) { return model.parts[static_cast<std::size_t>(part)].id; };
    model.rigid_merges.push_back({owners[0], body, false});
    for (std::size_t k = 1; k < owners.size(); ++k)
        model.rigid_merges.push_back({owners[0], owners[k], false});
    cards.warn(fmt::format("holds nodes of rigid part {}: it moves with that part{}", id(owners[0]),
                           owners.size() > 1
                               ? fmt::format(", and so do {} other rigid parts", owners.size() - 1)
                               : ""));
}

int free_part_id(const Draft& draft) {
    int id = 1;
    for (const Part& part : draft.model.parts) id = std::max(id, part.id + 1);
    return id;
}

/// CMO CON1 CON2 of _SPC, global axes.
void hold_body(Cards& cards, Draft& draft, Index body) {
    Card c = cards.next("CMO CON1 CON2");
    const int axes = c.choice("CMO", {0, 1}, {-1});
    const int moves = c.integer("CON1", within(0, 7)), turns = c.integer("CON2", within(0, 7));
    if (axes != 1 || !c.good()) return;
    const Index material = draft.model.parts[static_cast<std::size_t>(body)].material;
    auto& rigid =
        std::get<fabric::RigidCard>(draft.model.materials[static_cast<std::size_t>(material)].card);
    hold_along_axes(c.file(), HELD.at(static_cast<std::size_t>(moves)),
                    HELD.at(static_cast<std::size_t>(turns)), rigid);
}

}  // namespace

/// *CONSTRAINED_NODAL_RIGID_BODY[_SPC][_INERTIA][_TITLE]
void nodal_rigid_body(Cards& cards, Draft& draft) {
    static const Layout layout("PID CID NSID PNODE IPRT DRFLAG RRFLAG -");
    while (cards.rows()) {
        std::string title = "nodal rigid body";
        if (cards.has("TITLE")) title = cards.title();
        Index body = -1, set = -1;
        {
            Card c = cards.next(layout);
            const int id = c.new_id("PID", draft.parts, draft.model.parts.size());
            body = add_body(draft, id, title);
            // without a set the nodes are those of the set of the body's own number
            const bool is_named = c.given("NSID") && c.integer("NSID") != 0;
            set = c.row(is_named ? "NSID" : "PID", draft.node_sets);
            c.harmless("CID PNODE IPRT");  // of output
        }
        if (cards.has("SPC")) hold_body(cards, draft, body);
        if (cards.has("INERTIA")) part_inertia(cards, draft, body);
        if (set >= 0) join(cards, draft, body, draft.node_set[static_cast<std::size_t>(set)]);
    }
}

/// *CONSTRAINED_SPOTWELD: a rigid link that does not break.
void spotweld(Cards& cards, Draft& draft) {
    static const Layout layout("N1 N2 SN SS N M TF EP");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        const Index a = c.row("N1", draft.nodes), b = c.row("N2", draft.nodes);
        c.noted("SN SS N M TF EP", "the weld does not break");
        if (c.good() && draft.model.x[static_cast<std::size_t>(a)] ==
                            draft.model.x[static_cast<std::size_t>(b)])
            c.fault("N2", "a node away from N1");
        if (!c.good()) continue;
        const int id = free_part_id(draft);
        draft.parts.add(id, static_cast<Index>(draft.model.parts.size()), c.place());
        join(cards, draft, add_body(draft, id, "spot weld"), {a, b});
    }
}

/// *CONSTRAINED_ADAPTIVITY: a node in the middle of an edge that is not divided there.
void constrained_adaptivity(Cards& cards, Draft& draft) {
    static const Layout layout("DNID NID1 NID2 - - - - -");
    while (cards.rows()) {
        Card c = cards.next(layout);
        TiedNode tie;
        tie.node = c.row("DNID", draft.nodes);
        tie.ends = {c.row("NID1", draft.nodes), c.row("NID2", draft.nodes)};
        if (!c.good()) continue;
        const auto& x = draft.model.x;
        const Vec3 along =
            x[static_cast<std::size_t>(tie.ends[1])] - x[static_cast<std::size_t>(tie.ends[0])];
        const Vec3 from =
            x[static_cast<std::size_t>(tie.node)] - x[static_cast<std::size_t>(tie.ends[0])];
        if (tie.ends[0] == tie.ends[1] || tie.node == tie.ends[0] || tie.node == tie.ends[1] ||
            !(along.norm() > 0.0)) {
            c.fault("DNID", "a node between two others");
            continue;
        }
        tie.share = std::clamp(from.dot(along) / along.squaredNorm(), 0.05, 0.95);
        if (std::any_of(draft.model.tied_nodes.begin(), draft.model.tied_nodes.end(),
                        [&](const TiedNode& other) { return other.node == tie.node; })) {
            c.warn("DNID", "the node is tied already, the first edge counts");
            continue;
        }
        draft.model.tied_nodes.push_back(tie);
    }
}

}  // namespace corpuscle::io::keywords
