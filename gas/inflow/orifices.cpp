// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/inflow/orifices.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "gas/flight/crossing.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr double OFF_THE_WALL =
    1e-3;  ///< of the facets' size: inside, yet at the wall for any purpose

/// The orifice's own node, or the corners of its shell.
std::vector<Index> nodes_of(const OrificeCard& card, const auto& facets) {
    if (card.shell < 0) return {card.node};
    std::vector<Index> nodes;
    for (const auto& facet : facets)
        for (const Index node : facet.outward)
            if (std::find(nodes.begin(), nodes.end(), node) == nodes.end()) nodes.push_back(node);
    return nodes;
}

}  // namespace

Orifices::Orifices(const std::vector<OrificeCard>& cards, const std::vector<Triangle>& outward,
                   const std::vector<Triangle>& given, std::size_t closing,
                   const std::vector<Index>& shell, const std::array<Index, 3>& frame,
                   std::span<const Vec3> x)
    : cards_(cards), on_(cards.size()), pushed_(cards.size()), frame_(frame) {
    for (std::size_t o = 0; o < cards_.size(); ++o) {
        for (std::size_t t = 0; t < outward.size(); ++t) {
            const Triangle& c = outward[t];
            const bool touches = cards_[o].shell >= 0
                                     ? shell[t] == cards_[o].shell
                                     : std::find(c.begin(), c.end(), cards_[o].node) != c.end();
            if (!touches) continue;
            const double side = t < closing ? 1.0 : side_of_jet(o, c, given[t], x);
            on_[o].push_back({c, given[t], side});
        }
        if (cards_[o].pushes) pushed_[o] = nodes_of(cards_[o], on_[o]);
    }
    if (frame_[0] >= 0) frame_0_ = axes_of_frame(x);
}

/// Of a facet that does not close the bag, for Facet::side.
double Orifices::side_of_jet(std::size_t orifice, const Triangle& outward, const Triangle& given,
                             std::span<const Vec3> x) const {
    const OrificeCard& card = cards_[orifice];
    const auto normal = [&](const Triangle& c) { return vector_area(x[c[0]], x[c[1]], x[c[2]]); };
    const Vec3 jet = card.shell >= 0 ? Vec3(card.normal_sign * normal(given))
                                     : card.direction.value_or(Vec3::Zero());
    return jet.dot(normal(outward)) > 0.0 ? -1.0 : 1.0;
}

Vec3 Orifices::place(std::size_t orifice, std::span<const Vec3> x) const {
    const OrificeCard& card = cards_[orifice];
    if (on_[orifice].empty()) return x[card.node];
    Vec3 centre = Vec3::Zero();
    double area = 0.0;
    for (const Facet& facet : on_[orifice]) {
        const auto& [a, b, c] = facet.outward;
        const double part = vector_area(x[a], x[b], x[c]).norm();
        centre += part / 3.0 * (x[a] + x[b] + x[c]);
        area += part;
    }
    if (card.offset != 0.0) return centre / area + card.offset * normal(orifice, x);
    const Vec3 in = inward(orifice, x);
    const double off = OFF_THE_WALL * std::sqrt(area);
    if (card.shell < 0) return x[card.node] + off * in;
    const double below = depth(orifice, centre / area, in, x);
    return centre / area + (below > 0.5 * off ? off + below : off) * in;
}

Birth Orifices::birth(std::size_t orifice, double share, std::span<const Vec3> x_0,
                      std::span<const Vec3> x_1) const {
    const Vec3 from = place(orifice, x_0), to = place(orifice, x_1);
    const Birth there{from + share * (to - from), share};
    if (on_[orifice].empty() || cards_[orifice].offset != 0.0) return there;
    double apart = 0.0, area = 0.0;  // what nodes of a facet move against one another
    for (const Facet& facet : on_[orifice]) {
        const auto& [a, b, c] = facet.outward;
        area += vector_area(x_0[a], x_0[b], x_0[c]).norm();
        for (const auto& [i, j] : {std::pair{a, b}, {b, c}, {c, a}})
            apart = std::max(apart, (x_1[i] - x_0[i] - x_1[j] + x_0[j]).norm());
    }
    const bool strays = share * (1.0 - share) * apart > 0.25 * OFF_THE_WALL * std::sqrt(area);
    return strays ? Birth{from, 0.0} : there;
}

/// How far `at` lies outside of the shell's facets, along `inward`: that of a quad whose diagonal
/// bends inward has its middle there. Of a roof that is the lesser of both.                  [m]
double Orifices::depth(std::size_t orifice, const Vec3& at, const Vec3& inward,
                       std::span<const Vec3> x) const {
    constexpr double STEEPEST = 0.1;  // a facet folded over says nothing
    double least = INF;
    for (const Facet& facet : on_[orifice]) {
        const Vec3 n = facet.out(x).normalized();
        least =
            std::min(least, n.dot(at - x[facet.outward[0]]) / std::max(STEEPEST, -n.dot(inward)));
    }
    return least;
}

/// To where gas enters, at right angles to an orifice's facets, unit.
Vec3 Orifices::inward(std::size_t orifice, std::span<const Vec3> x) const {
    Vec3 out = Vec3::Zero();
    for (const Facet& facet : on_[orifice]) out += facet.out(x);
    return -out.normalized();
}

/// The way the gas of a shell's orifice flows, unit.
Vec3 Orifices::normal(std::size_t orifice, std::span<const Vec3> x) const {
    Vec3 normal = Vec3::Zero();
    for (const Facet& facet : on_[orifice])
        normal += vector_area(x[facet.given[0]], x[facet.given[1]], x[facet.given[2]]);
    return cards_[orifice].normal_sign * normal.normalized();
}

/// x from the first node to the second, z at right angles to all three.
Mat3 Orifices::axes_of_frame(std::span<const Vec3> x) const {
    const Vec3 along = (x[frame_[1]] - x[frame_[0]]).normalized();
    const Vec3 up = along.cross(x[frame_[2]] - x[frame_[0]]).normalized();
    Mat3 axes;
    axes << along, up.cross(along), up;
    return axes;
}

void Orifices::axes(std::span<const Vec3> x, std::vector<Vec3>& out) const {
    out.resize(size());
    Mat3 turn = Mat3::Identity();
    if (frame_[0] >= 0) turn = axes_of_frame(x) * frame_0_.transpose();
    for (std::size_t o = 0; o < size(); ++o)
        out[o] = cards_[o].shell >= 0 ? normal(o, x)
                                      : Vec3(turn * cards_[o].direction.value_or(Vec3::Zero()));
}

namespace {

/// Does the box of what the facet sweeps overlap with the path's?
bool is_near(const Path& path, const Triangle& facet, std::span<const Vec3> x_0,
             std::span<const Vec3> x_1) {
    for (int a = 0; a < 3; ++a) {
        const auto [i, j, k] = facet;
        const double low = std::min(
                         {x_0[i][a], x_0[j][a], x_0[k][a], x_1[i][a], x_1[j][a], x_1[k][a]}),
                     high = std::max(
                         {x_0[i][a], x_0[j][a], x_0[k][a], x_1[i][a], x_1[j][a], x_1[k][a]});
        if (low > std::max(path.at_0[a], path.at_1[a]) ||
            high < std::min(path.at_0[a], path.at_1[a]))
            return false;
    }
    return true;
}

}  // namespace

int Orifices::passed_by_fabric(const FacetLists& lists, std::span<const Vec3> x_0,
                               std::span<const Vec3> x_1) const {
    const auto is_passed = [&](std::size_t o) {
        if (!on_[o].empty() && cards_[o].offset == 0.0) return false;
        const Path path{place(o, x_0), place(o, x_1)};
        if (lists.is_clear(path.at_0, path.at_1)) return false;
        const auto is_crossed_by = [&](const Triangle& facet) {
            return is_near(path, facet, x_0, x_1) && cross(path, facet, x_0.data(), x_1.data());
        };
        return lists.any_slab(path.at_0, path.at_1, [&](const Slab& slab, double, double) {
            bool is_crossed = false;
            lists.for_each_in(slab, [&](Index facet) {
                is_crossed = is_crossed || is_crossed_by(lists.triangles()[facet]);
            });
            return is_crossed;
        });
    };
    const parallel::Least first = parallel::least(
        size(), 0.0, [&](std::size_t o) { return is_passed(o) ? -1.0 : 0.0; }, 1);
    return first.value < 0.0 ? static_cast<int>(first.at) : -1;
}

}  // namespace corpuscle::gas
