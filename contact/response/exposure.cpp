// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/exposure.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {
namespace {

/// Sines of the angles, see exposure.hpp: of faces and nodes, of edges.
struct Ramp {
    double all, none;
    [[nodiscard]] double operator()(double sine) const {
        return std::clamp((none - sine) / (none - all), 0.0, 1.0);
    }
};
constexpr Ramp OF_FACES{0.0, 0.05}, OF_EDGES{-0.02, 0.0};

/// Sine of the angle by which triangles beside an edge lead towards d, at most.
/// @param own  third node of a triangle that is left out, or -1
double sine_at_edge(const Cloth& cloth, const Points& x, Index a, Index b, Index own,
                    const Vec3& d) {
    const Vec3 along = (x[b] - x[a]).normalized();
    double most = -1.0;
    for (const Index t : cloth.triangles_of(a)) {
        const Triangle& n = cloth.triangles[t];
        if (n[0] != b && n[1] != b && n[2] != b) continue;
        const Index other = n[0] + n[1] + n[2] - a - b;
        if (other == own) continue;
        Vec3 off = x[other] - x[a];
        off -= along.dot(off) * along;
        const double size = off.norm();
        if (size > 0.0) most = std::max(most, off.dot(d) / size);
    }
    return most;
}

/// Likewise of edges that leave a node.
double sine_at_node(const Cloth& cloth, const Points& x, Index node, const Vec3& d) {
    double most = -1.0;
    for (const Index t : cloth.triangles_of(node))
        for (const Index other : cloth.triangles[t]) {
            if (other == node) continue;
            const Vec3 off = x[other] - x[node];
            const double size = off.norm();
            if (size > 0.0) most = std::max(most, off.dot(d) / size);
        }
    return most;
}

}  // namespace

double exposure(const Cloth& cloth, const Points& x, const Pair& pair, const Nearest& nearest) {
    const auto& n = pair.node;
    const double gap = nearest.apart.norm();
    if (!(gap > 0.0)) return 1.0;
    const Vec3 up = nearest.apart / gap;  // from the second place to the first
    if (pair.is_edges)
        return OF_EDGES(std::max(sine_at_edge(cloth, x, n[0], n[1], -1, -up),
                                 sine_at_edge(cloth, x, n[2], n[3], -1, up)));
    std::array<Index, 3> on{};
    int count = 0;
    for (int k = 1; k < 4; ++k)
        if (nearest.weight[k] != 0.0) on[static_cast<std::size_t>(count++)] = n[k];
    if (count == 3) return 1.0;
    if (count == 1) return OF_FACES(sine_at_node(cloth, x, on[0], up));
    const Index own = n[1] + n[2] + n[3] - on[0] - on[1];
    return OF_FACES(sine_at_edge(cloth, x, on[0], on[1], own, up));
}

}  // namespace corpuscle::contact
