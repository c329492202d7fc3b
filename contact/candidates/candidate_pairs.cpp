// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What becomes a row of the lists, and when a row has to be looked at.
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/candidates/candidates.hpp"

namespace corpuscle::contact {
namespace {

/// A float that is not below x >= 0.
float rounded_up(double x) {
    return static_cast<float>(x) * (1.0F + std::numeric_limits<float>::epsilon());
}

}  // namespace

/// Lists two edges without a common node, if a card has them touch.
void Candidates::meet_edges(Feature a, Feature b, Distances apart, const Outlook& ahead,
                            Chunk& out) const {
    // its name does not depend on who found whom
    if (cloth_.edge[b.triangle][b.side] < cloth_.edge[a.triangle][a.side]) std::swap(a, b);
    const Triangle &ta = cloth_.triangles[a.triangle], &tb = cloth_.triangles[b.triangle];
    const Index i = ta[a.side], j = ta[(a.side + 1) % 3];
    const Index r = tb[b.side], s = tb[(b.side + 1) % 3];
    const std::uint64_t key =
        key_of(true, cloth_.edge[a.triangle][a.side], cloth_.edge[b.triangle][b.side]);
    list({{i, j, r, s}, true}, key, {a.triangle, b.triangle, apart, ahead, out});
}

/// Lists a node and a triangle that is not its own, if a card has them touch.
void Candidates::meet_node(Feature n, Index triangle, Distances apart, const Outlook& ahead,
                           Chunk& out) const {
    const Index node = cloth_.triangles[n.triangle][n.side];
    const Triangle& t = cloth_.triangles[triangle];
    list({{node, t[0], t[1], t[2]}, false}, key_of(false, node, triangle),
         {n.triangle, triangle, apart, ahead, out});
}

/// Parts by which the sides of a pair touch.
PartPair Candidates::parts_of(std::uint64_t key) const {
    const auto first = static_cast<Index>(key >> 32 & 0x7FFFFFFFU),
               second = static_cast<Index>(key & 0xFFFFFFFFU);
    if (key >> 63 != 0) return {cloth_.edge_part[first], cloth_.edge_part[second]};
    return {cloth_.node_part[first], cloth_.part[second]};
}

/// Lists a pair that may come within reach while the lists live.
void Candidates::list(const Pair& pair, std::uint64_t key, const TrianglePair& where) const {
    const auto parts = parts_of(key);
    const auto [p, q] = parts;
    const int card =
        pair.is_edges ? cloth_.rules.edges_against(p, q) : cloth_.rules.nodes_against(p, q);
    if (card == Rules::NONE || cloth_.is_held(pair) ||
        std::binary_search(barred_.begin(), barred_.end(), key))
        return;
    const double thickness = cloth_.gap(card, parts, pair, where.a, where.b);
    const Outlook& ahead = where.ahead;
    double gap = where.apart.now, approach = 0.0;
    if (ahead.is_build) {
        approach = std::max(0.0, (gap - where.apart.late) / ahead.life);
    } else {
        const Vec3 apart = nearest(pair, ahead.now).apart;
        gap = apart.norm();
        approach = closing_rate(pair, apart, gap, ahead.now, ahead.life);
    }
    // only what is near has anything to remember
    const bool may_know = ahead.is_build && gap <= reach_ * thickness;
    const Index memory = may_know ? find_memory(key) : -1;
    const int side = cloth_.rules.side_of(card, p, q);
    VerletEntry watch{gap, rounded_up(reach_ * thickness), rounded_up(approach), where.a, where.b};
    watch.sum += motion_.age() * static_cast<double>(watch.approach) +
                 (motion_.displacement(where.a) + motion_.displacement(where.b));
    where.out.list.push_back({pair, memory, thickness, key, static_cast<std::int16_t>(card),
                              static_cast<std::int16_t>(side), false});
    where.out.watch.push_back(watch);
}

/// Bound of the rate at which a gap shrinks while nodes move as predicted. Seen along a fixed
/// direction, here that of the gap, each node of the one side leaves each of the other linearly in
/// time, so their least separation is never below the line from what it is now to what it is late.
/// @param time  from now until late                                                          [s]
double Candidates::closing_rate(const Pair& pair, const Vec3& apart, double gap, const Points& x,
                                double time) const {
    if (gap == 0.0) return 0.0;  // is within reach as it is
    Corners late;
    for (int k = 0; k < 4; ++k) late[k] = x[pair.node[k]] + time * motion_.velocity(pair.node[k]);
    return std::max(0.0, (gap - separation(pair, apart / gap, late)) / time);
}

void Candidates::tell_distance(std::size_t i, const Vec3& apart, double distance, const Points& x) {
    const double left = budget_.life - motion_.age();
    if (distance > static_cast<double>(verlet_.reach[i]) && left > 0.0)
        verlet_.set_approach(i, rounded_up(closing_rate(list_[i].pair, apart, distance, x, left)));
    verlet_.sum[i] = distance + spent(i);
}

}  // namespace corpuscle::contact
