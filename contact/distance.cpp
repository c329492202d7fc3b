// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/distance.hpp"

#include <algorithm>

namespace corpuscle::contact {
namespace {

/// part / whole in [0, 1]; the start of an edge that has no length.
double share(double part, double whole) {
    return whole > 0.0 ? std::clamp(part / whole, 0.0, 1.0) : 0.0;
}

}  // namespace

TriangleFoot foot_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a;
    const Vec3 ap = p - a;
    const double d1 = ab.dot(ap), d2 = ac.dot(ap);
    if (d1 <= 0.0 && d2 <= 0.0) return {TriangleRegion::NODE_0, {1, 0, 0}};

    const Vec3 bp = p - b;
    const double d3 = ab.dot(bp), d4 = ac.dot(bp);
    if (d3 >= 0.0 && d4 <= d3) return {TriangleRegion::NODE_1, {0, 1, 0}};

    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) {
        const double t = share(d1, d1 - d3);
        return {TriangleRegion::EDGE_01, {1 - t, t, 0}};
    }

    const Vec3 cp = p - c;
    const double d5 = ab.dot(cp), d6 = ac.dot(cp);
    if (d6 >= 0.0 && d5 <= d6) return {TriangleRegion::NODE_2, {0, 0, 1}};

    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) {
        const double t = share(d2, d2 - d6);
        return {TriangleRegion::EDGE_20, {1 - t, 0, t}};
    }

    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
        const double t = share(d4 - d3, (d4 - d3) + (d5 - d6));
        return {TriangleRegion::EDGE_12, {0, 1 - t, t}};
    }

    const double v = vb / (va + vb + vc), w = vc / (va + vb + vc);
    return {TriangleRegion::INSIDE, {1 - v - w, v, w}};
}

EdgeFeet feet_of_edges(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
    const Vec3 d = p1 - p0, e = q1 - q0, r = p0 - q0;
    const double dd = d.dot(d), ee = e.dot(e), de = d.dot(e);
    const double dr = d.dot(r), er = e.dot(r);
    const double cross = dd * ee - de * de;  // |d × e|²

    // Below an angle of 1e-3 the nearest places run along the edges at the least motion: the ends'
    // own node-triangle pairs hold such edges apart.
    constexpr double PARALLEL = 1e-6;
    const bool is_parallel = cross <= PARALLEL * dd * ee;

    double s = is_parallel ? 0.0 : (de * er - dr * ee) / cross;
    double t = is_parallel ? -1.0 : (dd * er - de * dr) / cross;
    if (s > 0.0 && s < 1.0 && t > 0.0 && t < 1.0) return {EdgeRegion::INSIDE, s, t};

    s = std::clamp(s, 0.0, 1.0);
    t = share(de * s + er, ee);
    s = share(de * t - dr, dd);
    return {is_parallel ? EdgeRegion::PARALLEL : EdgeRegion::END, s, t};
}

}  // namespace corpuscle::contact
