// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Which nodes and edges of two triangles may come within reach of each other while the lists live.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/candidates.hpp"

namespace corpuscle::contact {
namespace {

bool has_node(const Triangle& t, Index node) {
    return t[0] == node || t[1] == node || t[2] == node;
}

/// The next float, or the one after it.
float above(double x) {
    return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

/// Whether an edge's two nodes stay on one side.
bool is_aside(const std::array<int, 3>& side, int k) {
    return side[k] != 0 && side[k] == side[(k + 1) % 3];
}

}  // namespace

Candidates::Slab Candidates::slab_of(Index t, const Outlook& ahead) const {
    const auto& [a, b, c] = cloth_.triangles[t];
    const Points &x = ahead.x, &late = ahead.late;
    Slab out;
    out.normal = (x[b] - x[a]).cross(x[c] - x[a]).stableNormalized();
    const auto span = [&](const Points& at) {
        return std::minmax({out.normal.dot(at[a]), out.normal.dot(at[b]), out.normal.dot(at[c])});
    };
    std::tie(out.low, out.high) = span(x);
    std::tie(out.late_low, out.late_high) = span(late);
    double thickness = 0.0;
    for (const auto& of : cloth_.thickness) thickness = std::max(thickness, of[t]);
    out.margin = 0.5 * reach_ * thickness +
                 budget_ * std::max({motion_.slack(a), motion_.slack(b), motion_.slack(c)});
    return out;
}

/// Boxes of layers overlap long before the layers touch; seen along a layer's normal they are
/// apart. Along a fixed axis every node's place is linear in time, and so is its distance from each
/// node of the slab: what is out of reach, on the same side, at both ends of the time is so in
/// between.
/// @returns for each node of a triangle 1: stays above, -1: below, 0: may come within reach
std::array<int, 3> Candidates::sides_of(const Slab& slab, const Triangle& nodes, double apart,
                                        const Outlook& ahead) {
    const double high = slab.high + apart, late_high = slab.late_high + apart;
    const double low = slab.low - apart, late_low = slab.late_low - apart;
    std::array<int, 3> out;
    for (int k = 0; k < 3; ++k) {
        const double now = slab.normal.dot(ahead.x[nodes[k]]);
        const double late = slab.normal.dot(ahead.late[nodes[k]]);
        out[k] = int{(now > high) & (late > late_high)} - int{(now < low) & (late < late_low)};
    }
    return out;
}

/// Nodes of a against b, of b against a, edges of a against edges of b, as far as they own them, a
/// card has them touch, and they may come within reach.
void Candidates::list_pairs_of(Index a, const Slab& slab_a, Index b, const Slab& slab_b,
                               const Outlook& ahead, Chunk& out) const {
    const Triangle& ta = cloth_.triangles[a];
    const Triangle& tb = cloth_.triangles[b];
    const double apart = slab_a.margin + slab_b.margin;
    const auto are_all_aside = [](const std::array<int, 3>& s) {
        return s[0] != 0 && s[0] == s[1] && s[0] == s[2];
    };
    const std::array<int, 3> side_b = sides_of(slab_a, tb, apart, ahead);
    if (are_all_aside(side_b)) return;
    const std::array<int, 3> side_a = sides_of(slab_b, ta, apart, ahead);
    if (are_all_aside(side_a)) return;

    const Rules& rules = cloth_.rules;
    const Index part_a = cloth_.part[a], part_b = cloth_.part[b];
    const int a_on_b = rules.nodes_against(part_a, part_b),
              b_on_a = rules.nodes_against(part_b, part_a),
              edges = rules.edges_against(part_a, part_b);
    const auto node_against = [&](int card, Index from, Index node, Index t) {
        const Triangle& n = cloth_.triangles[t];
        if (has_node(n, node) || !node_box_[node].overlaps(triangle_box_[t])) return;
        consider({{node, n[0], n[1], n[2]}, false}, card, key_of(false, node, t),
                 {from, t, ahead, out});
    };
    for (int k = 0; k < 3; ++k) {
        if (a_on_b != Rules::NONE && cloth_.owns_node(a, k) && side_a[k] == 0)
            node_against(a_on_b, a, ta[k], b);
        if (b_on_a != Rules::NONE && cloth_.owns_node(b, k) && side_b[k] == 0)
            node_against(b_on_a, b, tb[k], a);
        if (edges == Rules::NONE || !cloth_.owns_edge(a, k) || is_aside(side_a, k)) continue;
        const Index i = ta[k], j = ta[(k + 1) % 3];
        const Box edge = edge_box(i, j);
        for (int m = 0; m < 3; ++m) {
            const Index r = tb[m], s = tb[(m + 1) % 3];
            if (!cloth_.owns_edge(b, m) || is_aside(side_b, m)) continue;
            if (i == r || i == s || j == r || j == s) continue;
            if (!edge.overlaps(edge_box(r, s))) continue;
            consider({{i, j, r, s}, true}, edges,
                     key_of(true, cloth_.edge[a][k], cloth_.edge[b][m]), {a, b, ahead, out});
        }
    }
}

Box Candidates::edge_box(Index a, Index b) const {
    Box box = node_box_[a];
    box.include(node_box_[b]);
    return box;
}

/// Of both sides together, in budgets.
double Candidates::slack_of(const Pair& pair) const {
    std::array<double, 4> of;
    for (int k = 0; k < 4; ++k) of[k] = motion_.slack(pair.node[k]);
    return pair.is_edges ? std::max(of[0], of[1]) + std::max(of[2], of[3])
                         : of[0] + std::max({of[1], of[2], of[3]});
}

/// Keeps a pair that may come within reach while the lists live.
void Candidates::consider(const Pair& pair, int card, std::uint64_t key,
                          const Meeting& where) const {
    const double thickness = cloth_.gap(card, where.a, where.b);
    const Outlook& ahead = where.ahead;
    double gap = nearest(pair, ahead.x).apart.norm();
    const double certain = reach_ * thickness + budget_ * slack_of(pair);
    const double approach =
        greatest_approach(pair, {motion_.velocity(pair.node[0]), motion_.velocity(pair.node[1]),
                                 motion_.velocity(pair.node[2]), motion_.velocity(pair.node[3])});
    if (gap > certain && gap > certain + ahead.life * approach) return;
    if (cloth_.is_held(pair) || std::binary_search(barred_.begin(), barred_.end(), key)) return;
    // only what is near has anything to remember
    const bool may_know = ahead.is_build && gap <= reach_ * thickness;
    const Index memory = may_know ? find_memory(key) : -1;
    if (&ahead.x != &ahead.now) gap = nearest(pair, ahead.now).apart.norm();
    const int side = cloth_.rules.side_of(card, cloth_.part[where.a], cloth_.part[where.b]);
    Watch watch{gap, above(reach_ * thickness), above(approach), where.a, where.b};
    watch.sum += spent(watch);
    where.out.list.push_back({pair, memory, thickness, key, static_cast<std::int16_t>(card),
                              static_cast<std::int16_t>(side), false});
    where.out.watch.push_back(watch);
}

}  // namespace corpuscle::contact
