// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *LOAD_RIGID_BODY: forces and moments on rigid bodies.

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"
#include "io/keywords/mesh/coordinates.hpp"

namespace corpuscle::io::keywords {
namespace {

/// DOF 4 and 8: along the normal of the plane through M1, M2, M3, which the load goes with.
void follow(Card& c, const Draft& draft, RigidLoad& load) {
    load.nodes = {c.row("M1", draft.nodes), c.row("M2", draft.nodes), c.row("M3", draft.nodes)};
    load.axis = local_axis(c.file(), 2, load.is_moment);
    c.harmless("CID");
    if (!c.good()) return;
    const auto x = [&](int k) -> const Vec3& {
        return draft.model.x[static_cast<std::size_t>(load.nodes[static_cast<std::size_t>(k)])];
    };
    const Vec3 a = x(1) - x(0), b = x(2) - x(0);
    if (!(a.cross(b).norm() > 1e-6 * a.norm() * b.norm()))
        c.fault("M3", "a node off the line through M1 and M2: the load is along their normal");
}

/// DOF 1 to 3, 5 to 7: along an axis of the deck, or of CID.
void go_along(Card& c, const Draft& draft, int k, RigidLoad& load) {
    const Index system = c.row_or_none("CID", draft.coordinates);
    c.harmless("M1 M2 M3");  // of loads that follow three nodes
    if (system < 0) {
        load.axis =
            load.is_moment ? c.file().spin(Vec3::Unit(k)) : c.file().direction(Vec3::Unit(k));
        return;
    }
    const LocalAxes& local = draft.coordinate[static_cast<std::size_t>(system)];
    load.axis = local_axis(c.file(), k, load.is_moment);
    if (local.moves)
        load.nodes = local.nodes;
    else if (c.good())
        load.axis = axes_at_start(draft, system) * load.axis;
}

}  // namespace

void load_rigid_body(Cards& cards, Draft& draft) {
    static const Layout layout("PID DOF LCID SF=1 CID M1 M2 M3");
    while (cards.rows()) {
        Card c = cards.next(layout);
        RigidLoad load;
        load.part = c.row("PID", draft.parts);
        if (load.part >= 0 && !is_rigid(draft, load.part)) c.fault("PID", "a part with *MAT_RIGID");
        const int dof = c.choice("DOF", {1, 2, 3, 4, 5, 6, 7, 8});
        load.is_moment = dof > 4;
        load.curve = c.row("LCID", draft.curves);
        load.scale = c.real("SF");
        draft.curve_uses.push_back({load.curve, c.place()});
        if (dof == 4 || dof == 8)
            follow(c, draft, load);
        else
            go_along(c, draft, dof % 4 - 1, load);
        if (!c.good()) continue;
        draft.body_uses.emplace_back(load.part, c.place());
        draft.model.rigid_loads.push_back(load);
    }
}

}  // namespace corpuscle::io::keywords
