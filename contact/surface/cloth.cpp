// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/surface/cloth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "solver/base/error.hpp"
#include "solver/base/sorted.hpp"

namespace corpuscle::contact {
namespace {

constexpr double MODULUS = 1e7;  ///< through the thickness, where nothing is said         [Pa]

/// By card and triangle. A skin (of solids: no thickness of its own) takes a small part of the mean
/// edge where the card gives none, so that there is a gap to keep.
std::vector<std::vector<double>> contact_thickness(const ContactSetup& setup, const Rules& rules,
                                                   double mean_edge) {
    constexpr double OF_A_SKIN = 1e-2;  ///< of the mean edge
    std::vector<std::vector<double>> thickness(rules.cards().size());
    for (std::size_t c = 0; c < thickness.size(); ++c)
        for (std::size_t t = 0; t < setup.triangles.size(); ++t) {
            const double own =
                setup.thickness[t] > 0.0 ? setup.thickness[t] : OF_A_SKIN * mean_edge;
            const double h = rules.thickness(static_cast<int>(c), setup.part[t], own);
            if (!(h > 0.0))
                throw InputError(fmt::format("contact {}: contact thickness = {}, expected > 0 [m]",
                                             setup.cards[c].id, h));
            thickness[c].push_back(h);
        }
    return thickness;
}

std::vector<Index> bodies_of(const ContactSetup& setup) {
    if (setup.body.empty()) return std::vector<Index>(setup.node_mass.size(), -1);
    return {setup.body.begin(), setup.body.end()};
}

std::vector<double> inverse_masses(const ContactSetup& setup, const std::vector<Index>& body) {
    std::vector<double> inverse(setup.node_mass.size(), 0.0);
    for (const Triangle& t : setup.triangles)
        for (const Index node : t) {
            if (setup.held[node] || body[node] >= 0) continue;
            if (!(setup.node_mass[node] > 0.0))
                throw InputError(fmt::format(
                    "contact {}: a free node at ({:.6g}, {:.6g}, {:.6g}) has no mass",
                    setup.cards[0].id, setup.x0[node].x(), setup.x0[node].y(), setup.x0[node].z()));
            inverse[node] = 1.0 / setup.node_mass[node];
        }
    return inverse;
}

/// Mean length of the edges, each seen from its triangles. [m]
double mean_edge_of(const ContactSetup& setup) {
    double sum = 0.0;
    for (const Triangle& t : setup.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum += (setup.reference_x[t[k]] - setup.reference_x[t[(k + 1) % 3]]).norm();
    return sum / static_cast<double>(std::max<std::size_t>(1, 3 * setup.triangles.size()));
}

void list_body_nodes(Cloth& cloth) {
    for (std::size_t n = 0; n < cloth.body.size(); ++n)
        if (cloth.body[n] >= 0) cloth.body_node.push_back(static_cast<Index>(n));
    const auto body_of = [&](Index n) { return cloth.body[n]; };
    std::ranges::stable_sort(cloth.body_node, {}, body_of);
    const Index bodies = cloth.body_node.empty() ? 0 : body_of(cloth.body_node.back()) + 1;
    for (Index b = 0; b <= bodies; ++b)
        cloth.body_start.push_back(static_cast<Index>(
            std::ranges::lower_bound(cloth.body_node, b, {}, body_of) - cloth.body_node.begin()));
}

/// Fills `owned` and `edge`: the first triangle that has a node or edge owns it.
void find_owners(Cloth& cloth) {
    cloth.owned.assign(cloth.triangles.size(), 0);
    std::vector<std::uint8_t> is_taken(cloth.inverse_mass.size(), 0);
    std::map<std::pair<Index, Index>, Index> name;
    for (std::size_t t = 0; t < cloth.triangles.size(); ++t) {
        auto& edge = cloth.edge.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = cloth.triangles[t][k], b = cloth.triangles[t][(k + 1) % 3];
            const auto [named, is_new] =
                name.emplace(std::minmax(a, b), static_cast<Index>(name.size()));
            edge[k] = named->second;
            if (!std::exchange(is_taken[a], 1)) cloth.owned[t] |= 1U << k;
            if (is_new) cloth.owned[t] |= 8U << k;
        }
    }
    cloth.edge_part.assign(name.size(), -1);
}

/// Fills `node_part` and `edge_part`.
void find_parts(Cloth& cloth) {
    std::map<std::set<Index>, Index> combined;
    const auto find = [&](std::vector<Index>& part_of, auto&& row_of) {
        std::map<Index, std::set<Index>> several;  // of those on borders
        for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                Index& part = part_of[row_of(t, k)];
                if (part < 0) part = cloth.part[t];
                if (!cloth.rules.are_alike(part, cloth.part[t]))
                    several[row_of(t, k)].insert({part, cloth.part[t]});
            }
        for (const auto& [row, parts] : several) {
            const auto [known, is_new] = combined.emplace(parts, -1);
            if (is_new) known->second = cloth.rules.combine(parts);
            part_of[row] = known->second;
        }
    };
    cloth.node_part.assign(cloth.inverse_mass.size(), -1);
    find(cloth.node_part, [&](std::size_t t, std::size_t k) { return cloth.triangles[t][k]; });
    find(cloth.edge_part, [&](std::size_t t, std::size_t k) { return cloth.edge[t][k]; });
    cloth.rules.choose(std::vector<std::uint8_t>(cloth.rules.cards().size(), 0));
}

/// Nodes that share an edge with each node, and all that are nearer along edges than `reach`.
void find_near_nodes(double reach, Cloth& cloth) {
    const std::size_t nodes = cloth.inverse_mass.size();
    std::vector<std::vector<Index>> ring(nodes);
    for (std::size_t i = 0; i < nodes; ++i) {
        for (const auto& edge : cloth.edges_opposite(static_cast<Index>(i)))
            ring[i].insert(ring[i].end(), edge.begin(), edge.end());
        sort_unique(ring[i]);
    }
    const auto length = [&](Index a, Index b) {
        return (cloth.reference_x[a] - cloth.reference_x[b]).norm();
    };
    std::vector<std::pair<Index, double>> found;  // with the distance to it
    cloth.near_start.assign(1, 0);
    for (std::size_t i = 0; i < nodes; ++i) {
        const auto node = static_cast<Index>(i);
        found.clear();
        for (const Index n : ring[i]) found.emplace_back(n, length(node, n));
        for (std::size_t f = 0; f < found.size(); ++f) {
            const auto [at, path] = found[f];
            if (path >= reach) continue;
            for (const Index n : ring[at]) {
                const bool is_known =
                    n == node || std::any_of(found.begin(), found.end(),
                                             [n](const auto& k) { return k.first == n; });
                if (!is_known) found.emplace_back(n, path + length(at, n));
            }
        }
        std::sort(found.begin(), found.end());
        cloth.near_bits.push_back(0);
        for (const auto& [n, path] : found) {
            cloth.near_node.push_back(n);
            cloth.near_bits.back() |= std::uint64_t{1} << n % 64;
        }
        cloth.near_start.push_back(static_cast<Index>(cloth.near_node.size()));
    }
}

void list_triangles_of_nodes(Cloth& cloth) {
    cloth.node_start.assign(cloth.inverse_mass.size() + 1, 0);
    for (const Triangle& t : cloth.triangles)
        for (const Index n : t) ++cloth.node_start[n + 1];
    std::partial_sum(cloth.node_start.begin(), cloth.node_start.end(), cloth.node_start.begin());
    cloth.node_triangle.resize(static_cast<std::size_t>(cloth.node_start.back()));
    cloth.node_edge.resize(cloth.node_triangle.size());
    std::vector<Index> next(cloth.node_start.begin(), cloth.node_start.end() - 1);
    for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& of = cloth.triangles[t];
            const Index entry = next[of[k]]++;
            cloth.node_triangle[entry] = static_cast<Index>(t);
            cloth.node_edge[entry] = {of[(k + 1) % 3], of[(k + 2) % 3]};
        }
}

void find_star_heights(Cloth& cloth) {
    cloth.star_height.assign(cloth.inverse_mass.size(), INF);
    for (const Triangle& t : cloth.triangles) {
        const Vec3 &a = cloth.reference_x[t[0]], &b = cloth.reference_x[t[1]],
                   &c = cloth.reference_x[t[2]];
        const double twice_area = (b - a).cross(c - a).norm();
        const std::array<double, 3> opposite = {(c - b).norm(), (a - c).norm(), (b - a).norm()};
        for (int k = 0; k < 3; ++k)
            if (opposite[k] > 0.0)
                cloth.star_height[t[k]] =
                    std::min(cloth.star_height[t[k]], twice_area / opposite[k]);
    }
}

void list_nodes(Cloth& cloth) {
    for (const Triangle& t : cloth.triangles)
        cloth.nodes.insert(cloth.nodes.end(), t.begin(), t.end());
    sort_unique(cloth.nodes);
}

void set_mobility(const ContactSetup& setup, Cloth& cloth) {
    cloth.mobility.resize(cloth.inverse_mass.size());
    for (std::size_t n = 0; n < cloth.mobility.size(); ++n) {
        cloth.mobility[n].setConstant(cloth.inverse_mass[n]);
        if (setup.held_axes.empty()) continue;
        for (int k = 0; k < 3; ++k)
            if (setup.held_axes[n] >> k & 1) cloth.mobility[n][k] = 0.0;
    }
}

}  // namespace

Cloth::Cloth(const ContactSetup& setup)
    : rules(setup.cards, setup.curves, setup.parts),
      triangles(setup.triangles),
      part(setup.part),
      growth_time(setup.growth_time),
      mean_edge(mean_edge_of(setup)),
      body(bodies_of(setup)),
      reference_x(setup.reference_x.begin(), setup.reference_x.end()),
      x0(setup.x0.begin(), setup.x0.end()),
      patches(make_patches(setup.reference_x, triangles)) {
    thickness = contact_thickness(setup, rules, mean_edge);
    modulus = setup.modulus;
    if (modulus.empty()) modulus.assign(triangles.size(), MODULUS);
    inverse_mass = inverse_masses(setup, body);
    set_mobility(setup, *this);
    node_thickness.assign(inverse_mass.size(), 0.0);
    for (std::size_t c = 0; c < thickness.size(); ++c)
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            if (!rules.concerns(static_cast<int>(c), part[t])) continue;
            greatest_thickness = std::max(greatest_thickness, thickness[c][t]);
            for (const Index n : triangles[t])
                node_thickness[n] = std::max(node_thickness[n], thickness[c][t]);
        }
    find_owners(*this);
    find_parts(*this);
    list_triangles_of_nodes(*this);
    find_near_nodes(2.0 * greatest_thickness, *this);
    find_star_heights(*this);
    list_nodes(*this);
    list_body_nodes(*this);
}

double Cloth::gap(int card, PartPair parts, const Pair& pair, Index a, Index b) const {
    const auto& of = thickness[static_cast<std::size_t>(card)];
    const bool is_turned = rules.side_of(card, parts.first, parts.second) < 0;
    const auto side = [&](int surface, Index owner, Index from, Index to) {
        if (rules.is_on_side(card, surface, part[owner])) return of[owner];
        for (const Index t : triangles_of(from))
            if (std::ranges::count(triangles[t], to) > 0 &&
                rules.is_on_side(card, surface, part[t]))
                return of[t];
        return of[owner];
    };
    const auto& n = pair.node;
    return 0.5 * (side(is_turned ? 1 : 0, a, n[0], n[pair.is_edges ? 1 : 0]) +
                  side(is_turned ? 0 : 1, b, n[2], n[3]));
}

bool Cloth::is_held(const Pair& pair) const {
    // not a body against another, or against held nodes
    return std::ranges::all_of(pair.node, [&](Index n) {
        return !(inverse_mass[n] > 0.0) && body[n] == body[pair.node[0]];
    });
}

bool Cloth::are_beside(Index node, Index other) const {
    if ((near_bits[node] >> other % 64 & 1) == 0) return false;  // most are not
    return std::binary_search(near_node.begin() + near_start[node],
                              near_node.begin() + near_start[node + 1], other);
}

}  // namespace corpuscle::contact
