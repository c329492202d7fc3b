// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/chart_layout.hpp"

#include <algorithm>
#include <cmath>
#include <Eigen/Eigenvalues>
#include <utility>

namespace corpuscle::contact {
namespace {

constexpr double STEEPEST = 0.2;  ///< cosine of a triangle's angle to the plane, at least
constexpr double FAR = 3.0;       ///< mean edges: farther patches can be told apart by their places
constexpr double WHOLE = 1e-6;    ///< of a region's area, to which it is covered just once

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double area_of(const std::array<Vec2, 3>& u) {
    return 0.5 * std::abs(cross(u[1] - u[0], u[2] - u[0]));
}

}  // namespace

EdgeSides sides_of_edges(const Cloth& cloth) {
    EdgeSides sides;
    std::vector<int> count;
    for (std::size_t t = 0; t < cloth.triangles.size(); ++t)
        for (const Index edge : cloth.edge[t]) {
            if (static_cast<std::size_t>(edge) >= sides.size()) {
                sides.resize(static_cast<std::size_t>(edge) + 1, {-1, -1});
                count.resize(sides.size(), 0);
            }
            if (count[edge] < 2) sides[edge][count[edge]] = static_cast<Index>(t);
            ++count[edge];
        }
    for (std::size_t e = 0; e < sides.size(); ++e)
        if (count[e] != 2) sides[e] = {-1, -1};
    return sides;
}

ChartLayout::ChartLayout(const Cloth& cloth, const EdgeSides& sides, Index patch)
    : cloth_(cloth), sides_(sides), met_(cloth.triangles.size(), 0) {
    Points corners;
    for (const Index t : cloth.patches[patch])
        for (const Index n : cloth.triangles[t]) corners.push_back(cloth.reference_x[n]);
    for (const Vec3& x : corners) centre_ += x / static_cast<double>(corners.size());
    Mat3 spread = Mat3::Zero();
    for (const Vec3& x : corners) spread += (x - centre_) * (x - centre_).transpose();
    // the normal is that along which the patch is spread least
    axes_ = Eigen::SelfAdjointEigenSolver<Mat3>(spread).eigenvectors().rightCols<2>();
}

bool ChartLayout::are_near(Index p, Index q) {
    double square = INF;
    for (const Vec2& u : points(p))
        for (const Vec2& w : points(q)) square = std::min(square, (u - w).squaredNorm());
    return square <= std::pow(FAR * cloth_.mean_edge, 2);
}

double ChartLayout::least_height(Index triangle) const {
    const auto u = corners(triangle);
    return 2.0 * area_of(u) /
           std::max({(u[1] - u[0]).norm(), (u[2] - u[1]).norm(), (u[0] - u[2]).norm()});
}

std::optional<std::vector<Index>> ChartLayout::between(Index p, Index q) {
    std::vector<Vec2> both = points(p);
    for (const Vec2& u : points(q)) both.push_back(u);
    const ConvexRegion region(std::move(both));
    ++tried_;
    std::vector<Index> found{cloth_.patches[p].front()};
    met_[found.front()] = tried_;
    double area = 0.0;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const auto u = corners(found[i]);
        if (!is_flat_enough(found[i], u)) return {};
        const auto part = region.part_within(u);
        if (part == ConvexRegion::Part::NONE) continue;
        const bool is_whole = part == ConvexRegion::Part::ALL;
        area += is_whole ? area_of(u) : region.area_within(u);
        for (std::size_t k = 0; k < 3; ++k) {
            if (!is_whole && !region.is_crossed(u[k], u[(k + 1) % 3])) continue;
            const Index other = beyond(found[i], k, u);
            if (other < 0) return {};
            if (std::exchange(met_[other], tried_) != tried_) found.push_back(other);
        }
    }
    for (const Index patch : {p, q})
        for (const Index t : cloth_.patches[patch])
            if (met_[t] != tried_) return {};
    if (std::abs(area - region.area()) > WHOLE * region.area()) return {};
    return found;
}

const std::vector<Vec2>& ChartLayout::points(Index patch) {
    std::vector<Vec2>& u = points_[patch];
    if (!u.empty()) return u;
    std::vector<Index> nodes;
    for (const Index t : cloth_.patches[patch])
        nodes.insert(nodes.end(), cloth_.triangles[t].begin(), cloth_.triangles[t].end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const Index n : nodes) u.push_back(at(n));
    return u;
}

bool ChartLayout::is_flat_enough(Index triangle, const std::array<Vec2, 3>& u) const {
    const auto& [a, b, c] = cloth_.triangles[triangle];
    const Points& x = cloth_.reference_x;
    return area_of(u) > STEEPEST * vector_area(x[a], x[b], x[c]).norm();
}

/// The only other triangle at side k of one, if it lies beyond that side in the plane; else -1.
Index ChartLayout::beyond(Index triangle, std::size_t k, const std::array<Vec2, 3>& u) const {
    const auto& [first, second] = sides_[cloth_.edge[triangle][k]];
    const Index other = first == triangle ? second : second == triangle ? first : -1;
    if (other < 0) return -1;
    const Triangle& mine = cloth_.triangles[triangle];
    const Vec2 along = u[(k + 1) % 3] - u[k];
    const double side = cross(along, u[(k + 2) % 3] - u[k]);
    for (const Index n : cloth_.triangles[other])
        if (n != mine[k] && n != mine[(k + 1) % 3])
            return side * cross(along, at(n) - u[k]) < 0.0 ? other : -1;
    return -1;
}

}  // namespace corpuscle::contact
