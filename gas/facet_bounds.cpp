// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/facet_bounds.hpp"

#include <algorithm>
#include <array>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Exactly as the bound will hold it: in single precision. Zero where there is none.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 across = (b - a).cross(c - a);
    const double length = across.norm();
    if (!(length > 0.0)) return Vec3::Zero();
    return (across / length).cast<float>().cast<double>();
}

}  // namespace

void FacetBounds::update(const FacetLists& lists, std::span<const Vec3> x_0,
                         std::span<const Vec3> x_1) {
    const Grid& grid = lists.grid();
    const Vec3 half = 0.5 * grid.edge * Vec3(grid.count[0], grid.count[1], grid.count[2]);
    origin_ = grid.low + half;
    size_ = half.maxCoeff();
    const std::span<const Triangle> triangles = lists.triangles();

    bound_.resize(triangles.size());
    parallel::for_each(
        triangles.size(),
        [&](std::size_t f) {
            const auto& [i, j, k] = triangles[f];
            const Vec3 low_corner = x_0[i].cwiseMin(x_0[j]).cwiseMin(x_0[k]).cwiseMin(
                           x_1[i].cwiseMin(x_1[j]).cwiseMin(x_1[k])),
                       high_corner = x_0[i].cwiseMax(x_0[j]).cwiseMax(x_0[k]).cwiseMax(
                           x_1[i].cwiseMax(x_1[j]).cwiseMax(x_1[k]));
            FacetBound& bound = bound_[f];
            const Eigen::Vector3f low = (low_corner - origin_).cast<float>(),
                                  less = (origin_ - high_corner).cast<float>();
            bound.box = Eight{low[0], low[1], low[2], 0.0F, less[0], less[1], less[2], 0.0F};
            const auto heights = [&](std::span<const Vec3> x, const Vec3& normal) {
                return std::array{normal.dot(x[i] - origin_), normal.dot(x[j] - origin_),
                                  normal.dot(x[k] - origin_)};
            };
            Vec3 normal = unit_normal(x_0[i], x_0[j], x_0[k]);
            auto [low_0, high_0] = std::ranges::minmax(heights(x_0, normal));
            // A facet that is all but a line has no normal worth the name.
            if (high_0 - low_0 > 0.1 * ROUNDING * size_) normal = Vec3::Zero(), low_0 = 0.0;
            const auto [low_1, high_1] = std::ranges::minmax(heights(x_1, normal));
            for (int a = 0; a < 3; ++a) bound.normal[a] = static_cast<float>(normal[a]);
            bound.at_0 = static_cast<float>(low_0);
            bound.low_1 = static_cast<float>(low_1);
            bound.high_1 = static_cast<float>(high_1);
        },
        parallel::CHUNK);
}

}  // namespace corpuscle::gas
