// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/facet_bounds.hpp"

#include <algorithm>
#include <array>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

struct Span {
    Vec3 low = Vec3::Constant(INF), high = Vec3::Constant(-INF);
    Span& operator+=(const Span& o) {
        low = low.cwiseMin(o.low);
        high = high.cwiseMax(o.high);
        return *this;
    }
};

/// Exactly as the bound will hold it: in single precision. Zero where there is none.
Vec3 unit_normal(const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 across = (b - a).cross(c - a);
    const double length = across.norm();
    if (!(length > 0.0)) return Vec3::Zero();
    return (across / length).cast<float>().cast<double>();
}

}  // namespace

void FacetBounds::update(std::span<const Triangle> triangles, std::span<const Vec3> x_0,
                         std::span<const Vec3> x_1) {
    const auto swept = [&](std::size_t f) {
        Span box;
        for (const Index n : triangles[f]) {
            box += {x_0[n], x_0[n]};
            box += {x_1[n], x_1[n]};
        }
        return box;
    };
    const Span all = parallel::sum(triangles.size(), Span{}, swept);
    origin_ = 0.5 * (all.low + all.high);
    size_ = (all.high - all.low).maxCoeff();

    bound_.resize(triangles.size());
    parallel::for_each(triangles.size(), [&](std::size_t f) {
        const auto& [i, j, k] = triangles[f];
        const Span box = swept(f);
        FacetBound& bound = bound_[f];
        for (int a = 0; a < 3; ++a) {
            bound.low[a] = static_cast<float>(box.low[a] - origin_[a]);
            bound.high[a] = static_cast<float>(box.high[a] - origin_[a]);
        }
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
    });
}

}  // namespace corpuscle::gas
