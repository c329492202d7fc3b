// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/crossing_depth.hpp"

#include <algorithm>

#include "solver/base/constants.hpp"

namespace corpuscle::tools {
namespace {

/// A prism as what separates it from others wants it.
struct Solid {
    std::vector<Vec3> points;
    std::vector<Vec3> edges;    ///< round the facet, and through the thickness; unit
    std::vector<Vec3> normals;  ///< of its faces, one of two opposite ones
};

/// @param origin  that all solids share: small numbers are kept sharp
Solid solid(const Prism& prism, const Vec3& origin) {
    const std::vector<Vec3>& x = prism.corners;
    const Vec3 normal = (x[1] - x[0]).cross(x.back() - x[0]).normalized();
    Solid out;
    out.edges = out.normals = {normal};
    for (std::size_t i = 0; i < x.size(); ++i) {
        const Vec3 edge = (x[(i + 1) % x.size()] - x[i]).normalized();
        out.edges.push_back(edge);
        out.normals.push_back(edge.cross(normal));
        for (const double side : {-0.5, 0.5})
            out.points.emplace_back(x[i] - origin + side * prism.thickness * normal);
    }
    return out;
}

/// How far b must be moved along the axis or against it until they are apart; none of them: < 0.
double overlap(const Solid& a, const Solid& b, const Vec3& axis) {
    const auto reach = [&](const Solid& of) {
        double low = INF, high = -INF;
        for (const Vec3& point : of.points) {
            low = std::min(low, axis.dot(point));
            high = std::max(high, axis.dot(point));
        }
        return std::pair(low, high);
    };
    const auto [low_a, high_a] = reach(a);
    const auto [low_b, high_b] = reach(b);
    return std::min(high_a - low_b, high_b - low_a);
}

}  // namespace

double crossing_depth(const Prism& a, const Prism& b) {
    constexpr double PARALLEL = 1e-9;  // sine of the angle between edges that give no axis
    const Vec3& origin = a.corners.front();
    const Solid one = solid(a, origin), other = solid(b, origin);
    double least = INF;
    for (const auto* normals : {&one.normals, &other.normals})
        for (const Vec3& axis : *normals) least = std::min(least, overlap(one, other, axis));
    for (const Vec3& e : one.edges)
        for (const Vec3& f : other.edges) {
            const Vec3 axis = e.cross(f);
            if (axis.norm() > PARALLEL)
                least = std::min(least, overlap(one, other, axis.normalized()));
        }
    return std::max(0.0, least);
}

}  // namespace corpuscle::tools
