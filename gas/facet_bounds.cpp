// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/facet_bounds.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Least and largest of three.
struct Interval {
    float low, high;
};
Interval interval(float a, float b, float c) {
    return {std::min(std::min(a, b), c), std::max(std::max(a, b), c)};
}

float height(const Quad& normal, const Quad& x) {
    return normal[0] * x[0] + normal[1] * x[1] + normal[2] * x[2];
}

/// At t, at t + dt.
std::pair<Quad, Quad> halves(const Eight& a) {
    return {Quad{a[0], a[1], a[2], a[3]}, Quad{a[4], a[5], a[6], a[7]}};
}

Quad cross_product(const Quad& a, const Quad& b) {
    using Ints = std::int32_t __attribute__((vector_size(16)));
    constexpr Ints NEXT{1, 2, 0, 3};
    return __builtin_shuffle(a * __builtin_shuffle(b, NEXT) - __builtin_shuffle(a, NEXT) * b, NEXT);
}

}  // namespace

void FacetBounds::update(const FacetLists& lists, std::span<const Vec3> x_0,
                         std::span<const Vec3> x_1) {
    const Grid& grid = lists.grid();
    const Vec3 half = 0.5 * grid.edge * Vec3(grid.count[0], grid.count[1], grid.count[2]);
    origin_ = grid.low + half;
    size_ = half.maxCoeff();
    const std::span<const Triangle> triangles = lists.triangles();
    const auto nodes = static_cast<std::size_t>(lists.nodes().back()) + 1;
    node_.resize(nodes);
    parallel::for_each(lists.nodes().size(), [&](std::size_t i) {
        const Index n = lists.nodes()[i];
        const Eigen::Vector3f a = (x_0[n] - origin_).cast<float>(),
                              b = (x_1[n] - origin_).cast<float>();
        node_[n] = Eight{a[0], a[1], a[2], 0.0F, b[0], b[1], b[2], 0.0F};
    });

    // Half the slack of paths is for what a facet at t strays from its plane, all by rounding.
    const auto flat = static_cast<float>(0.5 * ROUNDING * size_);
    bound_.resize(triangles.size());
    parallel::for_each(
        triangles.size(),
        [&](std::size_t f) {
            const auto& [i, j, k] = triangles[f];
            const auto [a, d] = halves(node_[i]);
            const auto [b, e] = halves(node_[j]);
            const auto [c, g] = halves(node_[k]);
            const auto least = [](const Quad& p, const Quad& q) { return p < q ? p : q; };
            const auto most = [](const Quad& p, const Quad& q) { return p > q ? p : q; };
            const Quad low = least(least(least(a, b), c), least(least(d, e), g)),
                       less = -most(most(most(a, b), c), most(most(d, e), g));
            const Quad across = cross_product(b - a, c - a);
            const float square = height(across, across);
            Quad normal = square > 0.0F ? across * (1.0F / std::sqrt(square)) : Quad{};
            auto [low_0, high_0] =
                interval(height(normal, a), height(normal, b), height(normal, c));
            // A facet that is all but a line has no normal worth the name.
            if (!(high_0 - low_0 <= flat)) normal = Quad{}, low_0 = 0.0F;
            const auto [low_1, high_1] =
                interval(height(normal, d), height(normal, e), height(normal, g));
            FacetBound& bound = bound_[f];
            bound.box = Eight{low[0], low[1], low[2], 0.0F, less[0], less[1], less[2], 0.0F};
            bound.normal = {normal[0], normal[1], normal[2]};
            bound.at_0 = low_0;
            bound.low_1 = low_1;
            bound.high_1 = high_1;
            const Quad side = -less - low;
            bound.size = std::max({side[0], side[1], side[2]});
        },
        parallel::CHUNK);
}

}  // namespace corpuscle::gas
