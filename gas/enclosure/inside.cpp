// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/inside.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::gas {
namespace {

constexpr double ROUNDING = 1e-12;  ///< of a facet's height over a point, by distances
constexpr double NEAR = 1e-9;       ///< of the surface's size: far above rounding, far below a gap

using Corner = std::array<double, 3>;

/// Which side of the edge a-b a point of the plane is on. Always reckoned from the lower node to
/// the higher, so that both facets of an edge hear the same.
bool is_left(const Corner& a, const Corner& b, Index node_a, Index node_b, double px, double py) {
    if (node_a > node_b) return !is_left(b, a, node_b, node_a, px, py);
    return (b[0] - a[0]) * (py - a[1]) - (b[1] - a[1]) * (px - a[0]) >= 0.0;
}

}  // namespace

double solid_angle(std::span<const Triangle> wall, const Vec3& point, std::span<const Vec3> x) {
    double angle = 0.0;
    for (const Triangle& t : wall) {
        const Vec3 a = x[t[0]] - point, b = x[t[1]] - point, c = x[t[2]] - point;
        const double la = a.norm(), lb = b.norm(), lc = c.norm(), height = a.dot(b.cross(c));
        if (std::abs(height) <= ROUNDING * la * lb * lc) continue;  // in its plane: half its angle
        angle +=
            2.0 * std::atan2(height, la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
    }
    return angle;
}

InsideTest::InsideTest(std::span<const Triangle> outward, std::span<const Vec3> x)
    : low_(Vec3::Constant(INF)), high_(Vec3::Constant(-INF)) {
    for (const Triangle& t : outward)
        for (const Index n : t) {
            low_ = low_.cwiseMin(x[n]);
            high_ = high_.cwiseMax(x[n]);
        }
    const Vec3 size = high_ - low_;
    int ray = 0;
    size.minCoeff(&ray);
    axis_ = {(ray + 1) % 3, (ray + 2) % 3, ray};  // a right-handed turn of the axes
    near_ = NEAR * size.maxCoeff();

    const double edge = std::sqrt(std::max(size[axis_[0]] * size[axis_[1]], near_ * near_) /
                                  static_cast<double>(outward.size()));
    for (int k = 0; k < 2; ++k)
        columns_[k] = 1 + static_cast<std::size_t>(std::min(1000.0, size[axis_[k]] / edge));

    const auto corner = [&](Index n) {
        return Corner{x[n][axis_[0]], x[n][axis_[1]], x[n][axis_[2]]};
    };
    for (const Triangle& t : outward)
        facets_.push_back({corner(t[0]), corner(t[1]), corner(t[2]), t});

    const auto each_column = [&](const Facet& f, auto&& use) {
        std::array<std::size_t, 2> from{}, to{};
        for (int k = 0; k < 2; ++k) {
            from[k] = along(k, std::min({f.a[k], f.b[k], f.c[k]}));
            to[k] = along(k, std::max({f.a[k], f.b[k], f.c[k]}));
        }
        for (std::size_t j = from[1]; j <= to[1]; ++j)
            for (std::size_t i = from[0]; i <= to[0]; ++i) use(j * columns_[0] + i);
    };
    start_.assign(columns_[0] * columns_[1] + 1, 0);
    for (const Facet& f : facets_) each_column(f, [&](std::size_t c) { ++start_[c + 1]; });
    for (std::size_t c = 1; c < start_.size(); ++c) start_[c] += start_[c - 1];
    in_.resize(static_cast<std::size_t>(start_.back()));
    std::vector<Index> fill(start_.begin(), start_.end() - 1);
    for (std::size_t f = 0; f < facets_.size(); ++f)
        each_column(facets_[f], [&](std::size_t c) { in_[fill[c]++] = static_cast<Index>(f); });
}

std::size_t InsideTest::along(int axis, double at) const {
    const double low = low_[axis_[axis]], size = high_[axis_[axis]] - low;
    const double share = size > 0.0 ? (at - low) / size : 0.0;
    const auto count = static_cast<double>(columns_[axis]);
    return static_cast<std::size_t>(std::clamp(std::floor(share * count), 0.0, count - 1.0));
}

std::optional<int> InsideTest::winding(const Vec3& point) const {
    const double px = point[axis_[0]], py = point[axis_[1]], pz = point[axis_[2]];
    const std::size_t column = along(1, py) * columns_[0] + along(0, px);
    int above = 0, all = 0;
    for (Index i = start_[column]; i < start_[column + 1]; ++i) {
        const Facet& f = facets_[in_[i]];
        const bool ab = is_left(f.a, f.b, f.node[0], f.node[1], px, py);
        if (ab != is_left(f.b, f.c, f.node[1], f.node[2], px, py) ||
            ab != is_left(f.c, f.a, f.node[2], f.node[0], px, py))
            continue;
        const int sign = ab ? 1 : -1;  // its normal looks along the ray, or against it
        const double u = (f.b[0] - f.a[0]), v = (f.b[1] - f.a[1]);
        const double s = (f.c[0] - f.a[0]), t = (f.c[1] - f.a[1]);
        const double area = u * t - v * s;
        const double beta = ((px - f.a[0]) * t - (py - f.a[1]) * s) / area;
        const double gamma = (u * (py - f.a[1]) - v * (px - f.a[0])) / area;
        const double z = f.a[2] + beta * (f.b[2] - f.a[2]) + gamma * (f.c[2] - f.a[2]);
        if (!(std::abs(z - pz) > near_)) return {};
        all += sign;
        if (z > pz) above += sign;
    }
    if (all != 0) return {};  // the ray grazes a corner
    return above;
}

}  // namespace corpuscle::gas
