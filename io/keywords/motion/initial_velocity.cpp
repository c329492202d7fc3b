// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <iterator>
#include <numeric>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

using Rows = std::vector<Index>;

Rows all_nodes(const Draft& draft) {
    Rows rows(draft.model.x.size());
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

void set_velocity(Draft& draft, const Rows& nodes, const Vec3& velocity) {
    draft.model.velocity.resize(draft.model.x.size(), Vec3::Zero());
    for (const Index node : nodes) draft.model.velocity[static_cast<std::size_t>(node)] = velocity;
}

bool has_shells(const Model& model, Index part) {
    return std::any_of(model.shells.begin(), model.shells.end(),
                       [&](const Shell& shell) { return shell.part == part; });
}

/// Nodes of their shells; of parts without any (nodal rigid bodies, beams) those that ride on them.
Rows nodes_of_parts(const Draft& draft, const Rows& parts) {
    const Model& model = draft.model;
    Rows nodes, bare;
    std::copy_if(parts.begin(), parts.end(), std::back_inserter(bare),
                 [&](Index part) { return !has_shells(model, part); });
    const auto holds = [](const Rows& rows, Index part) {
        return std::find(rows.begin(), rows.end(), part) != rows.end();
    };
    for (const Shell& shell : model.shells)
        if (holds(parts, shell.part))
            for (const Index node : shell.nodes)
                if (node >= 0) nodes.push_back(node);  // none: a shell with faults
    for (const RigidExtraNode& extra : model.rigid_extra_nodes)
        if (holds(bare, extra.part)) nodes.push_back(extra.node);
    return nodes;
}

Vec3 translation(Card& c) {
    // membrane nodes do not turn
    c.noted("VXR VYR VZR", "nodes have no rotation here");
    return c.direction("VX", "VY", "VZ");
}

}  // namespace

void initial_velocity(Cards& cards, Draft& draft) {
    Rows nodes, others;
    bool has_others = false;
    {
        Card c = cards.next("NSID NSIDEX BOXID IRIGID ICID");
        const Index set = c.row_or_none("NSID", draft.node_sets);
        nodes = set < 0 ? all_nodes(draft) : draft.node_set[static_cast<std::size_t>(set)];
        const Index except = c.row_or_none("NSIDEX", draft.node_sets);
        has_others = c.given("NSIDEX") && c.integer("NSIDEX") != 0;
        if (except >= 0) others = draft.node_set[static_cast<std::size_t>(except)];
    }
    {
        Card c = cards.next("VX VY VZ VXR VYR VZR");
        set_velocity(draft, nodes, translation(c));
    }
    if (!has_others) return;
    Card c = cards.next("VX VY VZ VXR VYR VZR");
    set_velocity(draft, others, translation(c));
}

void initial_velocity_node(Cards& cards, Draft& draft) {
    static const Layout layout("NID VX VY VZ VXR VYR VZR ICID");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index node = c.row("NID", draft.nodes);
        const Vec3 velocity = translation(c);
        if (node >= 0) set_velocity(draft, {node}, velocity);
    }
}

void initial_velocity_rigid_body(Cards& cards, Draft& draft) {
    static const Layout layout("PID VX VY VZ VXR VYR VZR ICID");
    while (cards.rows()) {
        Card c = cards.next(layout);
        RigidVelocity rigid;
        rigid.part = c.row("PID", draft.parts);
        rigid.velocity = c.direction("VX", "VY", "VZ");
        rigid.spin = c.spin("VXR", "VYR", "VZR");
        if (rigid.part >= 0 && !is_rigid(draft, rigid.part))
            c.fault("PID", "a part with *MAT_RIGID");
        expect_lead(c, draft, "PID", rigid.part);
        draft.model.rigid_velocity.push_back(rigid);
    }
}

namespace {

/// What *INITIAL_VELOCITY_GENERATION sets in motion.
struct Movers {
    Rows nodes, parts;
    Vec3 velocity = Vec3::Zero();
    double spin = 0.0;  ///< OMEGA [rad/s]
};

/// STYP 1 part set, 2 part, 3 node set; ID = 0: everything.
Movers proxies(Card& c, const Draft& draft) {
    Movers m;
    const bool all = c.integer("ID") == 0;
    const int type = all ? c.integer("STYP", NON_NEGATIVE) : c.choice("STYP", {1, 2, 3});
    m.spin = c.real("OMEGA");
    m.velocity = c.direction("VX", "VY", "VZ");
    if (all) {
        m.nodes = all_nodes(draft);
        return m;
    }
    if (!c.good()) return m;
    const Registry& named = type == 1 ? draft.part_sets : type == 2 ? draft.parts : draft.node_sets;
    const Index row = c.row("ID", named);
    if (row < 0) return m;
    if (type == 3)
        m.nodes = draft.node_set[static_cast<std::size_t>(row)];
    else
        m.parts = type == 2 ? Rows{row} : draft.part_set[static_cast<std::size_t>(row)];
    if (type != 3) m.nodes = nodes_of_parts(draft, m.parts);
    return m;
}

void generation(Cards& cards, Draft& draft) {
    Movers m;
    {
        Card c = cards.next("ID STYP OMEGA VX VY VZ IVATN ICID");
        m = proxies(c, draft);
    }
    Card c = cards.next("XC YC ZC NX NY NZ PHASE IRIGID");
    if (c.choice("IRIGID", {0, 1}) == 1)  // goes before the velocities of *PART_INERTIA
        std::erase_if(draft.inertia_start, [&](const RigidVelocity& start) {
            return std::find(m.parts.begin(), m.parts.end(), start.part) != m.parts.end();
        });
    const Vec3 centre = c.point("XC", "YC", "ZC");
    Vec3 axis = c.vector("NX", "NY", "NZ");
    if (axis.x() == -999.0) c.fault("NX", "a direction: axes by node numbers are not acted on yet");
    if (m.spin != 0.0 && c.good() && axis.isZero(0.0)) c.fault("NX", "an axis, for OMEGA is given");
    if (!axis.isZero(0.0)) axis.normalize();
    const Vec3 turning = c.file().spin(m.spin * axis);  // [rad/s]
    for (const Index node : m.nodes)
        set_velocity(
            draft, {node},
            m.velocity + turning.cross(draft.model.x[static_cast<std::size_t>(node)] - centre));
}

}  // namespace

void initial_velocity_generation(Cards& cards, Draft& draft) {
    do generation(cards, draft);
    while (cards.more());
}

}  // namespace corpuscle::io::keywords
