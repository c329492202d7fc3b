// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/exposure.hpp"

#include <algorithm>

namespace corpuscle::contact {
namespace {

constexpr double FULL = 0.0, NONE = 0.02;  ///< greatest n · u
constexpr double LEAST_WEIGHT = 1e-12;     ///< below it a corner takes no part

/// visit(p, q) for the other two nodes of each triangle at node a that touches a part.
template <class Visit>
void for_triangles_at(const Cloth& cloth, Index a, Index part, Visit&& visit) {
    const bool may_differ = cloth.rules.has_combined();
    const auto triangles = cloth.triangles_of(a);
    for (std::size_t k = 0; const auto& [p, q] : cloth.edges_opposite(a)) {
        const Index own = cloth.part[triangles[k++]];
        if (!may_differ || cloth.rules.touch(own, part)) visit(p, q);
    }
}

/// Greatest n · u beside an edge.
double rise_beside_edge(const Cloth& cloth, const Points& x, Index a, Index b, const Vec3& n,
                        Index part) {
    const Vec3 along = (x[b] - x[a]).normalized();
    double most = -1.0;
    for_triangles_at(cloth, a, part, [&](Index p, Index q) {
        if (p != b && q != b) return;
        const Index third = p == b ? q : p;
        Vec3 into = x[third] - x[a];
        into -= along.dot(into) * along;
        const double length = into.norm();
        if (length > 0.0) most = std::max(most, n.dot(into) / length);
    });
    return most;
}

/// Greatest n · u along the edges of a node.
double rise_round_node(const Cloth& cloth, const Points& x, Index a, const Vec3& n, Index part) {
    double most = -1.0;
    for_triangles_at(cloth, a, part, [&](Index p, Index q) {
        for (const Index b : {p, q}) {
            const Vec3 along = x[b] - x[a];
            const double length = along.norm();
            if (length > 0.0) most = std::max(most, n.dot(along) / length);
        }
    });
    return most;
}

}  // namespace

double exposure(const Cloth& cloth, PartPair parts, const Points& x, const Pair& pair,
                const Nearest& places, double gap) {
    const auto [first, second] = parts;
    const Vec3 normal = places.apart / gap;
    const auto& node = pair.node;
    double most = -1.0;
    if (pair.is_edges) {
        most = rise_beside_edge(cloth, x, node[0], node[1], -normal, second);
        if (most < NONE)
            most = std::max(most, rise_beside_edge(cloth, x, node[2], node[3], normal, first));
    } else {
        std::array<Index, 3> on{};
        int count = 0;
        for (int k = 1; k < 4; ++k)
            if (places.weight[k] < -LEAST_WEIGHT) on[count++] = node[k];
        if (count == 1) most = rise_round_node(cloth, x, on[0], normal, first);
        if (count == 2) most = rise_beside_edge(cloth, x, on[0], on[1], normal, first);
        if (count < 3 && most < NONE)
            most = std::max(most, rise_round_node(cloth, x, node[0], -normal, second));
    }
    return std::clamp((NONE - most) / (NONE - FULL), 0.0, 1.0);
}

}  // namespace corpuscle::contact
