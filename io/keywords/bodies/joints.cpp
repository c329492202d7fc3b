// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Joints of rigid parts, and nodes that are tied in one place.

#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

/// As far as nodes of one place may lie apart, over the length of the scene: the joint is midway.
constexpr double ONE_PLACE = 1e-3, EXACT = 1e-9;

double extent(const Draft& draft) {
    Eigen::AlignedBox3d box;
    for (const Vec3& x : draft.model.x) box.extend(x);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// The rigid part that leads the body which the field's node is of; -1 with a fault.
Index part_of_node(Card& c, Draft& draft, const char* field, Index node) {
    if (node < 0) return -1;
    const Index part = rigid_owners(draft)[static_cast<std::size_t>(node)];
    if (part < 0)
        c.fault(field, "a node of a rigid part, or one that *CONSTRAINED_EXTRA_NODES gives to it");
    return part;
}

/// The place of two nodes that a joint keeps together.
Vec3 place_of(Card& c, const Draft& draft, const char* field, Index a, Index b) {
    const auto& x = draft.model.x;
    const Vec3 &at_a = x[static_cast<std::size_t>(a)], &at_b = x[static_cast<std::size_t>(b)];
    const double apart = (at_a - at_b).norm(), whole = extent(draft);
    if (apart > ONE_PLACE * whole)
        c.fault(field, fmt::format("a node where the other one is, not {:.4g} beside it", apart));
    else if (apart > EXACT * whole)
        c.warn(field, fmt::format("lies {:.3g} beside the other node: the joint is midway", apart));
    return 0.5 * (at_a + at_b);
}

void joint(Cards& cards, Draft& draft, bool has_axis) {
    static const Layout layout("N1 N2 N3 N4 N5 N6 RPS DAMP");
    while (cards.rows()) {
        RigidJoint joint;
        joint.name =
            fmt::format("*{} {}", cards.block().keyword, draft.model.rigid_joints.size() + 1);
        if (cards.has("ID")) {
            Card c = cards.next("JID TITLE:70");
            joint.name = fmt::format("*{} {}", cards.block().keyword, c.id("JID", IdKind::OTHER));
            c.harmless("TITLE");
        }
        Card c = cards.next(layout);
        const Index a = c.row("N1", draft.nodes), b = c.row("N2", draft.nodes);
        joint.parts = {part_of_node(c, draft, "N1", a), part_of_node(c, draft, "N2", b)};
        c.harmless("RPS DAMP N5 N6");  // of a penalty: this joint is exact
        Index a_2 = -1, b_2 = -1;
        if (has_axis) {
            a_2 = c.row("N3", draft.nodes), b_2 = c.row("N4", draft.nodes);
            for (const auto& [field, node, part] :
                 {std::tuple{"N3", a_2, joint.parts[0]}, std::tuple{"N4", b_2, joint.parts[1]}})
                if (node >= 0 && part >= 0 && part_of_node(c, draft, field, node) != part)
                    c.fault(field,
                            fmt::format("a node of the body of {}", field[1] == '3' ? "N1" : "N2"));
        } else {
            c.harmless("N3 N4");
        }
        if (c.good() && joint.parts[0] == joint.parts[1])
            c.fault("N2", "a node of another body than N1");
        if (!c.good()) continue;
        joint.places = {place_of(c, draft, "N2", a, b)};
        if (has_axis) joint.places.push_back(place_of(c, draft, "N4", a_2, b_2));
        if (has_axis && (joint.places[1] - joint.places[0]).norm() <= EXACT * extent(draft))
            c.fault("N3", "a node away from N1, for both are on the axis");
        if (c.good()) draft.model.rigid_joints.push_back(std::move(joint));
    }
}

/// What held a node holds the one that it is tied to.
void hand_on(Model& model, Index node, Index kept) {
    for (Support& support : model.supports)
        if (support.node == node) support.node = kept;
    for (PrescribedMotion& motion : model.motions) {
        std::replace(motion.nodes.begin(), motion.nodes.end(), node, kept);
        std::sort(motion.nodes.begin(), motion.nodes.end());
        motion.nodes.erase(std::unique(motion.nodes.begin(), motion.nodes.end()),
                           motion.nodes.end());
    }
}

/// Ties nodes of one place: to a rigid part that one of them is of, else to the first of them.
void weld(Draft& draft, const std::vector<Index>& nodes) {
    const std::vector<Index>& owner = rigid_owners(draft);
    const auto rigid = std::find_if(nodes.begin(), nodes.end(), [&](Index n) {
        return owner[static_cast<std::size_t>(n)] >= 0;
    });
    const Index kept = rigid != nodes.end() ? *rigid : nodes.front();
    for (const Index node : nodes) {
        if (node == kept || owner[static_cast<std::size_t>(node)] >= 0) continue;
        draft.model.tied_nodes.push_back({node, {kept, kept}, 0.0});
        hand_on(draft.model, node, kept);
    }
}

}  // namespace

void joint_spherical(Cards& cards, Draft& draft) {
    joint(cards, draft, /*has_axis=*/false);
}

void joint_revolute(Cards& cards, Draft& draft) {
    joint(cards, draft, /*has_axis=*/true);
}

/// *CONSTRAINED_TIED_NODES_FAILURE: nodes that are in one place are one.
void tied_nodes(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        Card c = cards.next("NSID EPPF ETYPE - - - - -");
        const Index set = c.row("NSID", draft.node_sets);
        c.noted("EPPF ETYPE", "the tie does not break: this cloth has no plastic strain");
        if (!c.good()) continue;
        const double reach = ONE_PLACE * ONE_PLACE * extent(draft);
        std::vector<Index> left = draft.node_set[static_cast<std::size_t>(set)];
        std::sort(left.begin(), left.end());
        left.erase(std::unique(left.begin(), left.end()), left.end());
        std::erase_if(left, [&](Index n) {
            return std::any_of(draft.model.tied_nodes.begin(), draft.model.tied_nodes.end(),
                               [&](const TiedNode& other) { return other.node == n; });
        });
        std::size_t alone = 0, places = 0;
        while (!left.empty()) {
            const Vec3 at = draft.model.x[static_cast<std::size_t>(left.front())];
            std::vector<Index> here;
            std::erase_if(left, [&](Index n) {
                const bool is_here =
                    (draft.model.x[static_cast<std::size_t>(n)] - at).norm() <= reach;
                if (is_here) here.push_back(n);
                return is_here;
            });
            if (here.size() < 2) ++alone;
            if (here.size() < 2) continue;
            weld(draft, here);
            ++places;
        }
        if (places == 0)
            c.fault("NSID", "nodes of which some are in one place: none of these are");
        else if (alone > 0)
            c.warn("NSID", fmt::format("ties the nodes of {} places; {} others lie alone and are "
                                       "free",
                                       places, alone));
    }
}

}  // namespace corpuscle::io::keywords
