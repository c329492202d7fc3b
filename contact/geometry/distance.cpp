// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/geometry/distance.hpp"

#include <algorithm>

namespace corpuscle::contact {
namespace {

/// part / whole in [0, 1]; the start of an edge that has no length.
double share(double part, double whole) {
    return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
}

/// Foot on the nearest of the three edges.
Vec3 foot_on_edges(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const std::array<const Vec3*, 3> x{&a, &b, &c};
    Vec3 best = Vec3::Zero();
    double least = INF;
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const Vec3 edge = *x[next] - *x[k];
        const double t = share(edge.dot(p - *x[k]), edge.squaredNorm());
        const double distance = (p - *x[k] - t * edge).squaredNorm();
        if (distance >= least) continue;
        least = distance;
        best.setZero();
        best[k] = 1.0 - t;
        best[next] = t;
    }
    return best;
}

/// Nearest places of two segments, p0 + s (p1 - p0) and q0 + t (q1 - q0).
struct EdgeFeet {
    bool
        is_inside;  ///< within both, their vector normal to them; at an end node-triangle pairs see it
    double s, t;  ///< in [0, 1]  [-]
};

/// Segments that are parallel or have no length are legal.
///
/// cost: at most 5 div, no sqrt
/// Source: the solution within both, clamped one after the other [Ericson 2005, 5.1.9]; of
/// parallels the best of the four ends.
EdgeFeet feet_of_edges(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
    const Vec3 d = p1 - p0, e = q1 - q0, r = p0 - q0;
    const double dd = d.dot(d), ee = e.dot(e), de = d.dot(e);
    const double dr = d.dot(r), er = e.dot(r);
    const double cross = dd * ee - de * de;  // |d × e|²

    // below an angle of 1e-6 the inner solution is rounding, and no nearer than an end's by 1e-6 of
    // a length
    constexpr double PARALLEL = 1e-12;
    if (cross > PARALLEL * dd * ee) {
        const double inner = (de * er - dr * ee) / cross;
        double s = std::clamp(inner, 0.0, 1.0), t = (de * s + er) / ee;
        if (inner > 0.0 && inner < 1.0 && t > 0.0 && t < 1.0) return {true, s, t};
        if (t < 0.0 || t > 1.0) {
            t = t < 0.0 ? 0.0 : 1.0;
            s = share(de * t - dr, dd);
        }
        return {false, s, t};
    }

    EdgeFeet best{false, 0.0, 0.0};
    double least = INF;
    const auto consider = [&](double s, double t) {
        const double distance = (r + s * d - t * e).squaredNorm();
        if (distance >= least) return;
        least = distance;
        best.s = s;
        best.t = t;
    };
    consider(0.0, share(er, ee));
    consider(1.0, share(er + de, ee));
    consider(share(-dr, dd), 0.0);
    consider(share(de - dr, dd), 1.0);
    return best;
}

}  // namespace

Vec3 foot_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    // without area the signs below are rounding; the edges are all there is, to 1e-6 of a length
    constexpr double SLIVER = 1e-12;
    if (ab.cross(ac).squaredNorm() <= SLIVER * ab.squaredNorm() * ac.squaredNorm())
        return foot_on_edges(p, a, b, c);

    const Vec3 ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {1, 0, 0};

    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) return {0, 1, 0};

    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double t = share(d1, d1 - d3);
        return {1 - t, t, 0};
    }

    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) return {0, 0, 1};

    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double t = share(d2, d2 - d6);
        return {1 - t, 0, t};
    }

    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double t = share(d4 - d3, (d4 - d3) + (d5 - d6));
        return {0, 1 - t, t};
    }

    const double v = vb / (va + vb + vc), w = vc / (va + vb + vc);
    return {1 - v - w, v, w};
}

Nearest nearest(const Pair& pair, const Corners& x) {
    if (pair.is_edges) {
        const auto [is_inside, s, t] = feet_of_edges(x[0], x[1], x[2], x[3]);
        const Vec3 apart = x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2]);
        return {{1.0 - s, s, t - 1.0, -t}, apart, is_inside};
    }
    const Vec3 w = foot_on_triangle(x[0], x[1], x[2], x[3]);
    return {{1.0, -w[0], -w[1], -w[2]}, x[0] - w[0] * x[1] - w[1] * x[2] - w[2] * x[3], true};
}

double separation(const Pair& pair, const Vec3& direction, const Corners& x) {
    std::array<double, 4> at;
    for (int k = 0; k < 4; ++k) at[k] = direction.dot(x[k]);
    return pair.is_edges ? std::min(at[0], at[1]) - std::max(at[2], at[3])
                         : at[0] - std::max({at[1], at[2], at[3]});
}

}  // namespace corpuscle::contact
