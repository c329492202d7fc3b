// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/rigid_walls/wall_shape.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::contact {

namespace {

Vec3 unit_or(const Vec3& v, double length, const Vec3& fallback) {
    return length > 0.0 ? Vec3(v / length) : fallback;
}

Nearby nearest_to(const HalfSpace& s, const Vec3& at) {
    return {s.normal.dot(at - s.point), s.normal};
}

Nearby nearest_to(const Plate& s, const Vec3& at) {
    return {s.axes.col(2).dot(at - s.corner), s.axes.col(2)};
}

Nearby nearest_to(const Ball& s, const Vec3& at) {
    const Vec3 out = at - s.centre;
    const double length = out.norm();
    return {length - s.radius, unit_or(out, length, Vec3::UnitZ())};
}

/// Outside: the nearest place on the mantle, on an end or on a rim. Inside: the nearest of the
/// three surfaces.
Nearby nearest_to(const Rod& s, const Vec3& at) {
    const Vec3 r = at - s.base;
    const double along = s.axis.dot(r);
    const Vec3 across = r - along * s.axis;
    const double width = across.norm();
    const Vec3 sideways = unit_or(across, width, s.axis.unitOrthogonal());
    const double side = width - s.radius;
    const bool is_upper = along - s.high > s.low - along;
    const double end = is_upper ? along - s.high : s.low - along;
    const Vec3 endways = is_upper ? s.axis : Vec3(-s.axis);
    if (side > 0.0 && end > 0.0) {
        const double gap = std::hypot(side, end);
        return {gap, (side * sideways + end * endways) / gap};
    }
    return side > end ? Nearby{side, sideways} : Nearby{end, endways};
}

Nearby nearest_to(const Brick& s, const Vec3& at) {
    const Vec3 q = s.axes.transpose() * (at - s.corner);
    const Vec3 beyond = (q - s.high).cwiseMax(s.low - q);  // of each pair of faces
    const Vec3 outside = beyond.cwiseMax(0.0);
    Vec3 towards;
    for (int a = 0; a < 3; ++a) towards[a] = q[a] - s.high[a] > s.low[a] - q[a] ? 1.0 : -1.0;
    const double gap = outside.norm();
    if (gap > 0.0) return {gap, s.axes * outside.cwiseProduct(towards) / gap};
    int face = 0;
    const double depth = beyond.maxCoeff(&face);
    return {depth, towards[face] * s.axes.col(face)};
}

/// The stretch of a path, in shares of it, that lies inside something convex.
struct Stretch {
    double in = -INF, out = INF;
    Vec3 normal = Vec3::Zero();  ///< where it comes in

    void cut(double from, double to, const Vec3& normal_in) {
        if (from > in) {
            in = from;
            normal = normal_in;
        }
        out = std::min(out, to);
    }
    void miss() { out = -INF; }
    /// Between two parallel planes: low < q + share · d < high.
    void cut_slab(double q, double d, double low, double high, const Vec3& axis) {
        if (d == 0.0) {
            if (!(q > low && q < high)) miss();
            return;
        }
        const double a = (low - q) / d, b = (high - q) / d;
        cut(std::min(a, b), std::max(a, b), d > 0.0 ? Vec3(-axis) : axis);
    }
    /// |r + share · d| < radius, for r and d in one plane or in space.
    ///
    ///     share = c / (-b + sqrt(b² - a c)),   a = d·d, b = r·d, c = r·r - radius²
    ///
    /// which does not cancel for places close to the surface.
    void cut_round(const Vec3& r, const Vec3& d, double radius) {
        const double a = d.squaredNorm(), b = r.dot(d);
        const double c = (r.norm() - radius) * (r.norm() + radius);
        const double root = b * b - a * c;
        if (a == 0.0 || root <= 0.0) {
            if (c >= 0.0) miss();
            return;
        }
        const double s = std::sqrt(root);
        const double from = b < 0.0 ? c / (s - b) : (-b - s) / a;
        const double to = b < 0.0 ? (s - b) / a : -c / (b + s);
        cut(from, to, (r + from * d).normalized());
    }
    [[nodiscard]] std::optional<Entry> entry() const {
        if (!(in < out) || in > 1.0 || out <= 0.0 || in == -INF) return {};
        return Entry{std::max(in, 0.0), normal};
    }
};

std::optional<Entry> entry_to(const HalfSpace& s, const Vec3& from, const Vec3& to) {
    const double q = s.normal.dot(from - s.point), d = s.normal.dot(to - from);
    if (d >= 0.0 || q + d >= 0.0) return {};
    return Entry{std::clamp(q / -d, 0.0, 1.0), s.normal};
}

std::optional<Entry> entry_to(const Plate& s, const Vec3& from, const Vec3& to) {
    const auto entry = entry_to(HalfSpace{s.corner, s.axes.col(2)}, from, to);
    if (!entry || !covers(s, from + entry->share * (to - from))) return {};
    return entry;
}

std::optional<Entry> entry_to(const Ball& s, const Vec3& from, const Vec3& to) {
    Stretch inside;
    inside.cut_round(from - s.centre, to - from, s.radius);
    return inside.entry();
}

std::optional<Entry> entry_to(const Rod& s, const Vec3& from, const Vec3& to) {
    const Vec3 r = from - s.base, d = to - from;
    const double along = s.axis.dot(r), step = s.axis.dot(d);
    Stretch inside;
    inside.cut_slab(along, step, s.low, s.high, s.axis);
    inside.cut_round(r - along * s.axis, d - step * s.axis, s.radius);
    return inside.entry();
}

std::optional<Entry> entry_to(const Brick& s, const Vec3& from, const Vec3& to) {
    const Vec3 q = s.axes.transpose() * (from - s.corner), d = s.axes.transpose() * (to - from);
    Stretch inside;
    for (int a = 0; a < 3; ++a) inside.cut_slab(q[a], d[a], s.low[a], s.high[a], s.axes.col(a));
    return inside.entry();
}

}  // namespace

Nearby nearest(const WallShape& shape, const Vec3& at) {
    return std::visit([&](const auto& s) { return nearest_to(s, at); }, shape);
}

std::optional<Entry> entry(const WallShape& shape, const Vec3& from, const Vec3& to) {
    return std::visit([&](const auto& s) { return entry_to(s, from, to); }, shape);
}

bool covers(const Plate& plate, const Vec3& at) {
    for (int a = 0; a < 2; ++a) {
        const double q = plate.axes.col(a).dot(at - plate.corner);
        if (!(q >= plate.low[a] && q <= plate.high[a])) return false;
    }
    return true;
}

Vec3 plane_normal(const WallShape& shape) {
    if (const auto* half = std::get_if<HalfSpace>(&shape)) return half->normal;
    if (const auto* plate = std::get_if<Plate>(&shape)) return plate->axes.col(2);
    return Vec3::Zero();
}

}  // namespace corpuscle::contact
