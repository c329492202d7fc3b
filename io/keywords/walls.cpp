// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <numeric>
#include <unordered_set>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

/// NSID = 0: every node; without those of NSIDEX.
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
    return nodes;
}

void planar_wall(Cards& cards, Draft& draft) {
    contact::PlanarWallCard wall;
    wall.id = static_cast<int>(draft.model.walls.size()) + 1;
    if (cards.has("ID") || cards.has("TITLE")) {
        Card c = cards.next("ID TITLE:70");
        wall.id = c.integer("ID", {1.0});
        wall.title = c.text("TITLE");
    }
    {
        Card c = cards.next("NSID NSIDEX BOXID OFFSET BIRTH DEATH=1e20 RWKSF=1");
        wall.nodes = stopped_nodes(c, draft);
        wall.birth = c.real("BIRTH", NON_NEGATIVE);
        wall.death = c.real("DEATH", POSITIVE);
    }
    {
        Card c = cards.next("XT YT ZT XH YH ZH FRIC WVEL");
        wall.point = c.vector("XT", "YT", "ZT");
        wall.normal = c.vector("XH", "YH", "ZH") - wall.point;
        wall.friction = c.real("FRIC", within(0.0, 1.0));
        c.harmless("WVEL");  // of FRIC = 2 and 3
        if (c.good() && wall.normal.isZero(0.0))
            c.fault("XH", "a head away from the tail");
        else
            wall.normal.normalize();
    }
    for (const contact::PlanarWallCard& other : draft.model.walls)
        if (other.id == wall.id)
            cards.fault(fmt::format("has id {}, as another wall has", wall.id));
    draft.model.walls.push_back(std::move(wall));
}

}  // namespace

void rigidwall_planar(Cards& cards, Draft& draft) {
    do planar_wall(cards, draft);
    while (cards.more());
}

}  // namespace corpuscle::io::keywords
