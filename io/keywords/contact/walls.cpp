// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/contact/walls.hpp"

#include <fmt/format.h>

#include <numeric>
#include <unordered_set>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

void wall_name(Cards& cards, contact::WallCard& wall) {
    if (!cards.has("ID") && !cards.has("TITLE")) return;
    Card c = cards.next("ID TITLE:70");
    wall.id = c.id("ID", IdKind::PART, NON_NEGATIVE);
    wall.title = c.text("TITLE");
}

std::vector<Index> stopped_nodes(Card& c, const Draft& draft) {
    std::vector<Index> nodes(draft.model.x.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    if (const Index set = c.row_or_none("NSID", draft.node_sets); set >= 0)
        nodes = draft.node_set[static_cast<std::size_t>(set)];
    if (const Index set = c.row_or_none("NSIDEX", draft.node_sets); set >= 0) {
        const auto& left_out = draft.node_set[static_cast<std::size_t>(set)];
        const std::unordered_set<Index> gone(left_out.begin(), left_out.end());
        std::erase_if(nodes, [&](Index node) { return gone.contains(node); });
    }
    if (const Index row = c.row_or_none("BOXID", draft.boxes); row >= 0) {
        const SetBox& box = draft.box[static_cast<std::size_t>(row)];
        std::erase_if(nodes, [&](Index node) {
            return !box.contains(draft.model.x[static_cast<std::size_t>(node)]);
        });
        if (nodes.empty()) c.fault("BOXID", "a box with nodes that the wall may stop in it");
    }
    return nodes;
}

Arrow arrow(Card& c) {
    Arrow a;
    a.tail = c.point("XT", "YT", "ZT");
    const Vec3 way = c.point("XH", "YH", "ZH") - a.tail;
    if (c.good() && way.isZero(0.0))
        c.fault("XH", "a head away from the tail");
    else
        a.direction = way.normalized();
    return a;
}

/// A length of 0 is endless both ways; the depth lies behind the tail.
contact::WallShape rectangle(Cards& cards, const Arrow& normal, bool has_depth) {
    constexpr double SQUARE = 1e-3;  // cosine up to which an edge stands upright on the normal
    Card c = cards.next(has_depth ? "XHEV YHEV ZHEV LENL LENM LENP" : "XHEV YHEV ZHEV LENL LENM");
    const Vec3 edge = c.point("XHEV", "YHEV", "ZHEV") - normal.tail;
    const double l = c.real("LENL", NON_NEGATIVE), m = c.real("LENM", NON_NEGATIVE);
    const Vec3& n = normal.direction;
    Vec3 along = edge - n.dot(edge) * n;
    if (l == 0.0 && m == 0.0)
        along = n.unitOrthogonal();
    else if (c.good() && (edge.isZero(0.0) || std::abs(n.dot(edge)) > SQUARE * edge.norm()))
        c.fault("XHEV", "the head of an edge that is square to the normal");
    along.normalize();

    contact::Brick block;
    block.corner = normal.tail;
    block.axes << along, n.cross(along), n;
    if (l > 0.0) block.low[0] = 0.0, block.high[0] = l;
    if (m > 0.0) block.low[1] = 0.0, block.high[1] = m;
    if (m > 0.0 && c.file().mirrors()) block.low[1] = -m, block.high[1] = 0.0;
    if (has_depth) {
        const double depth = c.real("LENP", NON_NEGATIVE);
        block.high[2] = 0.0;
        if (depth > 0.0) block.low[2] = -depth;
        return block;
    }
    if (l == 0.0 && m == 0.0) return contact::HalfSpace{normal.tail, n};
    return contact::Plate{
        block.corner, block.axes, {block.low[0], block.low[1]}, {block.high[0], block.high[1]}};
}

void skip_display(Cards& cards) {
    if (cards.has("DISPLAY") && cards.more()) cards.next("PID RO E PR").harmless_all();
}

void add_wall(Cards& cards, Draft& draft, contact::WallCard wall) {
    for (const contact::WallCard& other : draft.model.walls)
        if (wall.id != 0 && other.id == wall.id)
            cards.fault(fmt::format("has id {}, as another wall has", wall.id));
    draft.model.walls.push_back(std::move(wall));
}

namespace {

/// Without NSID, OFFSET > 0 takes the nodes that are as near to the plane at the start.
void nodes_near_plane(Card& c, const Draft& draft, double offset, const Arrow& plane,
                      std::vector<Index>& nodes) {
    if (offset == 0.0) return;
    if (c.given("NSID") && c.integer("NSID") != 0)
        return c.warn("OFFSET", "counts only without NSID, whose nodes are all taken");
    std::erase_if(nodes, [&](Index node) {
        const Vec3& at = draft.model.x[static_cast<std::size_t>(node)];
        return std::abs(plane.direction.dot(at - plane.tail)) > offset;
    });
}

/// _MOVING: along the normal; MASS = 0 is a wall that nothing slows down.
contact::WallMotion moving(Cards& cards, const Vec3& normal) {
    Card c = cards.next("MASS V0");
    contact::WallMotion motion;
    motion.mass = c.real("MASS", NON_NEGATIVE);
    motion.speed = c.real("V0");
    if (motion.mass > 0.0 || motion.speed != 0.0) motion.direction = normal;
    return motion;
}

void planar_wall(Cards& cards, Draft& draft) {
    contact::WallCard wall;
    wall_name(cards, wall);
    Arrow plane;
    {
        Card first = cards.next("NSID NSIDEX BOXID OFFSET BIRTH DEATH=1e20 RWKSF=1");
        wall.nodes = stopped_nodes(first, draft);
        wall.birth = first.real("BIRTH", NON_NEGATIVE);
        wall.death = first.real("DEATH", POSITIVE);
        const double offset = first.real("OFFSET", NON_NEGATIVE);
        Card c = cards.next("XT YT ZT XH YH ZH FRIC WVEL");
        plane = arrow(c);
        wall.friction = c.real("FRIC", within(0.0, 1.0));
        c.harmless("WVEL");  // of FRIC = 2 and 3
        nodes_near_plane(first, draft, offset, plane, wall.nodes);
    }
    wall.shape = contact::HalfSpace{plane.tail, plane.direction};
    if (cards.has("FINITE")) wall.shape = rectangle(cards, plane, /*has_depth=*/false);
    if (cards.has("MOVING")) wall.motion = moving(cards, plane.direction);
    if (cards.has("FORCES")) {
        Card c = cards.next("SOFT SSID N1 N2 N3 N4");
        c.noted("SOFT", "nodes come to rest within one step");
        c.harmless("SSID N1 N2 N3 N4");  // of output
    }
    skip_display(cards);
    add_wall(cards, draft, std::move(wall));
}

}  // namespace

void rigidwall_planar(Cards& cards, Draft& draft) {
    do planar_wall(cards, draft);
    while (cards.more());
}

}  // namespace corpuscle::io::keywords
