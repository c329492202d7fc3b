// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <variant>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

/// Gravity is the whole deck's: a file that is turned may not say its direction.
void expect_unturned(Card& c, const char* field, int axis) {
    constexpr double ROUNDING = 1e-9;
    if (!(c.file().direction(Vec3::Unit(axis)) - Vec3::Unit(axis)).isZero(ROUNDING))
        c.fault(field,
                "a body load in the deck itself: the file of this one is turned away from its "
                "direction");
}

void body_load(Cards& cards, Draft& draft, int axis) {
    Card c = cards.next("LCID SF=1 LCIDDR XC YC ZC CID");
    BodyLoad load;
    load.axis = axis;
    expect_unturned(c, "LCID", axis);
    load.curve = c.row("LCID", draft.curves);
    load.scale = c.real("SF");
    load.parts = draft.body_load_parts;
    draft.curve_uses.push_back({load.curve, c.place()});
    c.harmless("LCIDDR XC YC ZC");  // of dynamic relaxation, and of angular loads
    draft.model.body_loads.push_back(load);
}

/// Rows of LC, DOF and ACCEL, for parts: LC blank is a constant.
void gravity(Cards& cards, Draft& draft, bool is_set) {
    static const Layout layout("PID DOF LC ACCEL LCDR STGA STGR");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index row = c.row("PID", is_set ? draft.part_sets : draft.parts);
        BodyLoad load;
        load.axis = c.choice("DOF", {1, 2, 3}) - 1;
        expect_unturned(c, "DOF", load.axis);
        load.curve = c.row_or_none("LC", draft.curves);
        load.scale = c.real("ACCEL");
        c.harmless("LCDR");  // of dynamic relaxation
        draft.curve_uses.push_back({load.curve, c.place()});
        if (row < 0) continue;
        load.parts = is_set ? draft.part_set[static_cast<std::size_t>(row)] : std::vector{row};
        draft.model.body_loads.push_back(std::move(load));
    }
}

/// LCID SF AT, wherever they stand in the card.
PressureLoad pressure(Card& c, Draft& draft) {
    PressureLoad load;
    load.curve = c.row("LCID", draft.curves);
    load.scale = c.real("SF");
    load.arrival = c.real("AT", NON_NEGATIVE);
    draft.curve_uses.push_back({load.curve, c.place(), load.arrival});
    return load;
}

}  // namespace

void load_body_x(Cards& cards, Draft& draft) {
    body_load(cards, draft, 0);
}
void load_body_y(Cards& cards, Draft& draft) {
    body_load(cards, draft, 1);
}
void load_body_z(Cards& cards, Draft& draft) {
    body_load(cards, draft, 2);
}

void load_body_parts(Cards& cards, Draft& draft) {
    Card c = cards.next("PSID");
    if (const Index set = c.row("PSID", draft.part_sets); set >= 0)
        draft.body_load_parts = draft.part_set[static_cast<std::size_t>(set)];
}
void load_gravity_part(Cards& cards, Draft& draft) {
    gravity(cards, draft, /*is_set=*/false);
}
void load_gravity_part_set(Cards& cards, Draft& draft) {
    gravity(cards, draft, /*is_set=*/true);
}

void load_segment(Cards& cards, Draft& draft) {
    static const Layout layout("LCID SF=1 AT N1 N2 N3 N4 N5");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        PressureLoad load = pressure(c, draft);
        std::array<Index, 4> facet{c.row("N1", draft.nodes), c.row("N2", draft.nodes),
                                   c.row("N3", draft.nodes), c.row_or_none("N4", draft.nodes)};
        if (facet[3] < 0) facet[3] = facet[2];
        load.facets.push_back(c.file().facet(facet));
        draft.model.pressure_loads.push_back(std::move(load));
    }
}

void load_segment_set(Cards& cards, Draft& draft) {
    static const Layout layout("SSID LCID SF=1 AT DT");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        PressureLoad load = pressure(c, draft);
        if (const Index set = c.row("SSID", draft.segment_sets); set >= 0)
            load.facets = draft.segment_set[static_cast<std::size_t>(set)];
        draft.model.pressure_loads.push_back(std::move(load));
    }
}

void load_shell_element(Cards& cards, Draft& draft) {
    static const Layout layout("EID LCID SF=1 AT");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        PressureLoad load = pressure(c, draft);
        if (const Index shell = c.row("EID", draft.shells); shell >= 0)
            load.facets = {draft.model.shells[static_cast<std::size_t>(shell)].nodes};
        draft.model.pressure_loads.push_back(std::move(load));
    }
}

void load_shell_set(Cards& cards, Draft& draft) {
    static const Layout layout("ESID LCID SF=1 AT");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        PressureLoad load = pressure(c, draft);
        if (const Index set = c.row("ESID", draft.shell_sets); set >= 0)
            for (const Index shell : draft.shell_set[static_cast<std::size_t>(set)])
                load.facets.push_back(draft.model.shells[static_cast<std::size_t>(shell)].nodes);
        draft.model.pressure_loads.push_back(std::move(load));
    }
}

namespace {

/// The load along a direction as loads along the axes.
void push_along_axes(const Vec3& direction, const NodeLoad& load, std::vector<NodeLoad>& loads) {
    constexpr double ROUNDING = 1e-12;
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(direction[axis]) <= ROUNDING) continue;
        loads.push_back(load);
        loads.back().axis = axis;
        loads.back().scale *= direction[axis];
    }
}

/// Rows of DOF, LCID and SF, for nodes.
void node_load(Cards& cards, Draft& draft, bool is_set) {
    static const Layout layout("NID DOF LCID SF=1 CID M1 M2 M3");
    while (cards.rows()) {
        Card c = cards.next(layout);
        NodeLoad load;
        const Index row = c.row("NID", is_set ? draft.node_sets : draft.nodes);
        const int dof = c.choice("DOF", {1, 2, 3}, {4, 5, 6, 7, 8}) - 1;
        load.curve = c.row("LCID", draft.curves);
        load.scale = c.real("SF");
        c.harmless("M1 M2 M3");  // of loads that follow three nodes
        draft.curve_uses.push_back({load.curve, c.place()});
        if (row < 0 || load.curve < 0) continue;
        load.nodes = is_set ? draft.node_set[static_cast<std::size_t>(row)] : std::vector{row};
        push_along_axes(c.file().direction(Vec3::Unit(dof)), load, draft.model.node_loads);
    }
}

}  // namespace

void load_node_point(Cards& cards, Draft& draft) {
    node_load(cards, draft, /*is_set=*/false);
}
void load_node_set(Cards& cards, Draft& draft) {
    node_load(cards, draft, /*is_set=*/true);
}

void damping_part_mass(Cards& cards, Draft& draft) {
    const bool is_set = cards.block().keyword.starts_with("DAMPING_PART_MASS_SET");
    while (cards.rows()) {
        Card c = cards.next("PID LCID SF=1 FLAG");
        const Index row = c.row("PID", is_set ? draft.part_sets : draft.parts);
        const Index curve = c.row("LCID", draft.curves);
        const double scale = c.real("SF", NON_NEGATIVE);
        if (c.integer("FLAG") != 0) c.fault("FLAG", "0: damping by direction is not acted on yet");
        if (row < 0 || curve < 0) continue;
        for (const Index part :
             is_set ? draft.part_set[static_cast<std::size_t>(row)] : std::vector{row})
            draft.model.part_dampings.push_back({part, curve, scale});
    }
}

void damping_part_stiffness(Cards& cards, Draft& draft) {
    const bool is_set = cards.block().keyword.starts_with("DAMPING_PART_STIFFNESS_SET");
    while (cards.rows()) {
        Card c = cards.next("PID COEF");
        c.row("PID", is_set ? draft.part_sets : draft.parts);
        c.noted("COEF",
                "stiffness damping is not acted on: oscillations of single elements last longer "
                "(DAMP of *MAT_FABRIC damps them)");
    }
}

void damping_global(Cards& cards, Draft& draft) {
    Card c = cards.next("LCID VALDMP STX STY STZ SRX SRY SRZ");
    draft.model.mass_damping_curve = c.row_or_none("LCID", draft.curves);
    draft.model.mass_damping = c.real("VALDMP", NON_NEGATIVE);
    if (draft.model.mass_damping_curve >= 0)
        draft.model.mass_damping = 0.0;  // the curve goes before
    const Vec3 moves = c.vector("STX", "STY", "STZ"), turns = c.vector("SRX", "SRY", "SRZ");
    const bool all_blank = moves.isZero(0.0) && turns.isZero(0.0);  // then all are 1
    if (!all_blank && moves != Vec3::Ones())
        c.fault("STX",
                "STX = STY = STZ = 1, or all six blank: damping by direction is not acted on yet");
    const auto rigid = [&](const Part& part) {
        return part.material >= 0 &&
               std::holds_alternative<fabric::RigidCard>(
                   draft.model.materials[static_cast<std::size_t>(part.material)].card);
    };
    const auto& parts = draft.model.parts;
    if (!all_blank && turns != Vec3::Ones() && std::any_of(parts.begin(), parts.end(), rigid))
        c.warn("SRX", "taken as 1, as SRY and SRZ are: rigid bodies turn slower too");
}

void damping_frequency_range(Cards& cards, Draft&) {
    cards.warn(
        "is left out: what it would damp in its range of frequencies lasts longer (DAMP of "
        "*MAT_FABRIC damps cloth)");
    cards.abandon();
}

}  // namespace corpuscle::io::keywords
