// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"
#include "io/model/solid_skin.hpp"

namespace corpuscle::io::keywords {

bool is_rigid(const Draft& draft, Index part) {
    const Index material = draft.model.parts[static_cast<std::size_t>(part)].material;
    return material >= 0 && std::holds_alternative<fabric::RigidCard>(
                                draft.model.materials[static_cast<std::size_t>(material)].card);
}

void hold_along_axes(const FilePlace& file, unsigned moves, unsigned turns,
                     fabric::RigidCard& rigid) {
    const auto held = file.held(moves | turns << 3U);
    rigid.fixed_moves = held ? *held & 7U : moves;
    rigid.fixed_turns = held ? *held >> 3U : turns;
    if (!held) rigid.axes = file.mirrors() ? Mat3(-file.turn()) : file.turn();
}

namespace {

Mat3 tensor(Cards& cards) {
    Card c = cards.next("IXX IXY IXZ IYY IYZ IZZ");
    const double xx = c.real("IXX", POSITIVE), xy = c.real("IXY"), xz = c.real("IXZ");
    const double yy = c.real("IYY", POSITIVE), yz = c.real("IYZ"), zz = c.real("IZZ", POSITIVE);
    Mat3 inertia;
    inertia << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvalues();
    if (c.good() && !(moments[0] > 0.0))
        c.fault("IXX", "a tensor whose three principal moments are above 0");
    else if (c.good() && moments[2] > (1.0 + 1e-6) * (moments[0] + moments[1]))
        c.warn("IXX", "no body has such principal moments: one is above the sum of the others");
    return inertia;
}

/// XL YL ZL a place on the local x axis, XLIP YLIP ZLIP one in the local xy plane.
Mat3 local_axes(Cards& cards) {
    Card c = cards.next("XL YL ZL XLIP YLIP ZLIP CID");
    const Vec3 x = c.vector("XL", "YL", "ZL"), in_plane = c.vector("XLIP", "YLIP", "ZLIP");
    const Vec3 z = x.cross(in_plane);
    if (c.good() && !(z.norm() > 1e-6 * x.norm() * in_plane.norm())) {
        c.fault("XL", "two directions that span the local xy plane");
        return Mat3::Identity();
    }
    Mat3 axes;
    axes << x.normalized(), z.cross(x).normalized(), z.normalized();
    return axes;
}

}  // namespace

void part_inertia(Cards& cards, Draft& draft, Index part) {
    RigidInertia body;
    body.part = part;
    bool is_local = false;
    Index node = -1;
    {
        Card c = cards.next("XC YC ZC TM IRCS NODEID");
        body.centre = c.point("XC", "YC", "ZC");
        body.mass = c.real("TM", POSITIVE);
        is_local = c.choice("IRCS", {0, 1}) == 1;
        node = c.row_or_none("NODEID", draft.nodes);
    }
    if (node >= 0) {
        body.centre = draft.model.x[static_cast<std::size_t>(node)];
        draft.model.rigid_extra_nodes.push_back({part, node});
        draft.inertia_nodes.push_back(node);
    }
    body.inertia = tensor(cards);
    RigidVelocity start;
    start.part = part;
    {
        Card c = cards.next("VTX VTY VTZ VRX VRY VRZ");
        start.velocity = c.direction("VTX", "VTY", "VTZ");
        start.spin = c.spin("VRX", "VRY", "VRZ");
    }
    if (is_local) {
        const Mat3 axes = local_axes(cards);
        body.inertia = axes * body.inertia * axes.transpose();
    }
    if (const FilePlace& file = cards.file(); file.turns())
        body.inertia = (file.turn() * body.inertia * file.turn().transpose()).eval();
    if (!start.velocity.isZero(0.0) || !start.spin.isZero(0.0))
        draft.inertia_start.push_back(start);
    draft.model.rigid_inertia.push_back(body);
}

void section_solid(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("SECID ELFORM=1 AET - - COHOFF GASKETT");
        c.new_id("SECID", draft.sections, draft.section.size());
        c.harmless("ELFORM AET COHOFF GASKETT");  // solids are rigid here
        Section section;
        section.is_solid = true;
        draft.section.push_back(section);
    }
}

namespace {

/// Mirrored: nodes 1, 2 and 3, 4, and so on for those behind, change places; of a tetrahedron
/// (nodes 4 to 8 are one) 1 and 2 alone.
void turn_over(std::array<Index, 8>& nodes) {
    const bool is_tetrahedron =
        std::all_of(nodes.begin() + 4, nodes.end(), [&](Index n) { return n == nodes[3]; });
    for (std::size_t k = 0; k < (is_tetrahedron ? 2U : 8U); k += 2)
        std::swap(nodes[k], nodes[k + 1]);
}

/// EID PID and eight nodes, on one line or on two.
Solid solid_cards(Cards& cards, const Draft& draft, Place& place) {
    static const Layout one("EID:8 PID:8 N1:8 N2:8 N3:8 N4:8 N5:8 N6:8 N7:8 N8:8");
    static const Layout two("N1:8 N2:8 N3:8 N4:8 N5:8 N6:8 N7:8 N8:8 N9:8 N10:8");
    Solid solid;
    const auto read_nodes = [&](Card& c, std::size_t first) {
        for (std::size_t k = 0; k < 8; ++k) solid.nodes[k] = c.row(k + first, draft.nodes);
    };
    Card c = cards.next(one);
    place = c.place();
    solid.id = c.id(std::size_t{0}, IdKind::ELEMENT, {1.0});
    solid.part = c.row(std::size_t{1}, draft.parts);
    if (solid.part >= 0 && draft.part_has_solids[static_cast<std::size_t>(solid.part)] == 0)
        c.fault(std::size_t{1}, "a part with *SECTION_SOLID");
    if (c.given(std::size_t{2})) {
        read_nodes(c, 2);
    } else {
        Card more = cards.next(two);
        read_nodes(more, 0);
        for (const std::size_t i : {8U, 9U})
            if (more.given(i) && more.integer(i) != 0)
                more.fault(i, "blank: solids of 4 to 8 nodes are read");
    }
    if (c.file().mirrors()) turn_over(solid.nodes);
    return solid;
}

}  // namespace

void element_solid(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        Place place;
        const Solid solid = solid_cards(cards, draft, place);
        const bool has_nodes = std::all_of(solid.nodes.begin(), solid.nodes.end(),
                                           [](Index node) { return node >= 0; });
        if (!has_nodes || solid.part < 0) continue;  // reported
        const Vec3& origin = draft.model.x[static_cast<std::size_t>(solid.nodes[0])];
        if (!(bulk_of(faces_of(solid.nodes), draft.model.x, origin).volume > 0.0))
            cards.faults().fault(
                place, fmt::format("*ELEMENT_SOLID {} has no volume, expected nodes 1 to 4 "
                                   "counter-clockwise as seen from nodes 5 to 8",
                                   solid.id));
        if (!draft.solids.add(solid.id, static_cast<Index>(draft.solid.size()), place))
            cards.faults().fault(
                place, fmt::format("*ELEMENT_SOLID has id {}, as another one has", solid.id));
        draft.solid.push_back(solid);
    }
}

namespace {

/// Which rigid part each node belongs to, of merged ones their lead.
void find_owners(Draft& draft) {
    const Model& model = draft.model;
    draft.rigid_owner.assign(model.x.size(), -1);
    for (const Shell& shell : model.shells)
        if (shell.part >= 0 && is_rigid(draft, shell.part))
            for (const Index node : shell.nodes)
                if (node >= 0)
                    draft.rigid_owner[static_cast<std::size_t>(node)] = lead_of(draft, shell.part);
    for (const RigidExtraNode& extra : model.rigid_extra_nodes)
        draft.rigid_owner[static_cast<std::size_t>(extra.node)] = lead_of(draft, extra.part);
}

}  // namespace

const std::vector<Index>& rigid_owners(Draft& draft) {
    if (draft.rigid_owner.empty()) find_owners(draft);
    return draft.rigid_owner;
}

namespace {

/// Nodes of other rigid parts cannot ride on this one too.
void ride(Card& c, Draft& draft, const char* field, Index part, const std::vector<Index>& nodes) {
    if (draft.rigid_owner.empty()) find_owners(draft);
    Model& model = draft.model;
    const Index lead = lead_of(draft, part);
    for (const Index node : nodes) {
        Index& owner = draft.rigid_owner[static_cast<std::size_t>(node)];
        if (owner >= 0 && owner != lead)
            return c.fault(field, fmt::format("nodes of no other rigid part: node {} is of part {}",
                                              model.node_id[static_cast<std::size_t>(node)],
                                              model.parts[static_cast<std::size_t>(owner)].id));
        if (owner < 0) model.rigid_extra_nodes.push_back({part, node});
        owner = lead;
    }
}

Index rigid_part(Card& c, const Draft& draft) {
    const Index part = c.row("PID", draft.parts);
    if (part >= 0 && !is_rigid(draft, part)) c.fault("PID", "a part with *MAT_RIGID");
    return c.good() ? part : -1;
}

}  // namespace

void extra_nodes_node(Cards& cards, Draft& draft) {
    static const Layout layout("PID NID IFLAG");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index part = rigid_part(c, draft), node = c.row("NID", draft.nodes);
        if (part >= 0 && node >= 0) ride(c, draft, "NID", part, {node});
    }
}

void extra_nodes_set(Cards& cards, Draft& draft) {
    static const Layout layout("PID NSID IFLAG");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index part = rigid_part(c, draft), set = c.row("NSID", draft.node_sets);
        if (part >= 0 && set >= 0)
            ride(c, draft, "NSID", part, draft.node_set[static_cast<std::size_t>(set)]);
    }
}

}  // namespace corpuscle::io::keywords
