// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/response/overlap_area.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace corpuscle::contact {
namespace {

constexpr double STEEP = 0.25;      ///< of a place's own area, where it stands on edge
constexpr double LEAST = 1e-6;      ///< of it, wherever
constexpr double ON_EDGE = 1e-9;    ///< of a triangle's area: what counts as inside of its side
constexpr double AT_PLACE = 1e-12;  ///< of it: squared distance of what counts as the place

using Vec2 = Eigen::Vector2d;
using View = Eigen::Matrix<double, 2, 3>;  ///< onto the plane across a normal

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// A triangle as it is seen, counter-clockwise, with twice its area so and as it is.      [m^2]
struct Seen {
    std::array<Vec2, 3> at;
    double seen, whole;
    Seen(const View& view, const Vec3& a, const Vec3& b, const Vec3& c)
        : at{view * a, view * b, view * c},
          seen(cross(at[1] - at[0], at[2] - at[0])),
          whole((b - a).cross(c - a).norm()) {
        if (seen < 0.0) std::swap(at[1], at[2]);
        seen = std::abs(seen);
    }
};

/// What two triangles have in common: a convex polygon.
class Overlap {
public:
    /// [Sutherland & Hodgman 1974]
    Overlap(const Seen& a, const Seen& b) : count_(3) {
        std::copy(a.at.begin(), a.at.end(), at_.begin());
        for (int e = 0; e < 3; ++e) cut(b.at[e], b.at[(e + 1) % 3], ON_EDGE * b.seen);
    }
    /// What its corners at a place, within the root of `near`, have of its area.           [m^2]
    [[nodiscard]] double share_at(const Vec2& place, double near) const {
        std::array<double, MOST> side, part;
        double round = 0.0, area = 0.0, share = 0.0;
        for (int k = 0; k < count_; ++k) round += side[k] = (at_[next(k)] - at_[k]).norm();
        if (count_ < 3 || !(round > 0.0)) return 0.0;
        const auto lambda = [&](int k) { return (side[before(k)] + side[k]) / (2.0 * round); };
        Vec2 middle = Vec2::Zero();
        for (int k = 0; k < count_; ++k) middle += lambda(k) * at_[k];
        for (int k = 0; k < count_; ++k)
            area += part[k] = 0.5 * cross(at_[k] - middle, at_[next(k)] - middle);
        for (int k = 0; k < count_; ++k)
            if ((at_[k] - place).squaredNorm() <= near)
                share += (part[before(k)] + part[k] + lambda(k) * area) / 3.0;
        return share;
    }

private:
    static constexpr int MOST = 9;  ///< each of three sides that cut adds a corner for two at most
    [[nodiscard]] int next(int k) const { return k + 1 == count_ ? 0 : k + 1; }
    [[nodiscard]] int before(int k) const { return k == 0 ? count_ - 1 : k - 1; }
    /// Keeps what lies to the left of a line, or as good as on it.
    void cut(const Vec2& from, const Vec2& to, double near) {
        std::array<Vec2, MOST> kept;
        int count = 0;
        for (int k = 0; k < count_; ++k) {
            const Vec2 &p = at_[k], &q = at_[next(k)];
            const double h = cross(to - from, p - from), g = cross(to - from, q - from);
            if (h >= -near) kept[count++] = p;
            if ((h > near && g < -near) || (h < -near && g > near))
                kept[count++] = p + h / (h - g) * (q - p);
        }
        at_ = kept;
        count_ = count;
    }

    std::array<Vec2, MOST> at_;
    int count_;
};

/// body(triangle) for those that have a node; with a second one, that have both.
template <class Body>
void for_each_round(const View& view, const Cloth& cloth, const Points& x, Index a, Index b,
                    Body&& body) {
    for (const auto& [p, q] : cloth.edges_opposite(a))
        if (b < 0 || p == b || q == b) body(Seen(view, x[a], x[p], x[q]));
}

}  // namespace

ContactArea overlap_area(const Cloth& cloth, const Points& x, const Contact& c) {
    const auto& n = c.node;
    View view;
    view.row(0) = c.normal.unitOrthogonal();
    view.row(1) = c.normal.cross(view.row(0).transpose());
    Vec3 at = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
        if (c.weight[k] > 0.0) at += c.weight[k] * x[n[k]];
    const Vec2 place = view * at;

    double area = 0.0;
    std::array<double, 2> seen{}, whole{};  // twice, of either place's triangles
    const auto meet = [&](const Seen& a, const Seen& b) {
        if (a.seen > 0.0 && b.seen > 0.0)
            area += Overlap(a, b).share_at(place, AT_PLACE * std::max(a.seen, b.seen));
    };
    for_each_round(view, cloth, x, n[0], c.is_edges ? n[1] : -1, [&](const Seen& a) {
        seen[0] += a.seen;
        whole[0] += a.whole;
        seen[1] = whole[1] = 0.0;
        const auto with = [&](const Seen& b) {
            seen[1] += b.seen;
            whole[1] += b.whole;
            meet(a, b);
        };
        if (c.is_edges)
            for_each_round(view, cloth, x, n[2], n[3], with);
        else
            with(Seen(view, x[n[1]], x[n[2]], x[n[3]]));
    });
    const double own = std::min(whole[0], whole[1]) / 6.0;
    double steep = 0.0;
    for (int k = 0; k < 2; ++k)
        if (whole[k] > 0.0) steep = std::max(steep, 1.0 - seen[k] / whole[k]);
    return {std::max(area, (STEEP * steep + LEAST) * own), own};
}

}  // namespace corpuscle::contact
