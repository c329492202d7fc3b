// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/contact.hpp"

#include <algorithm>
#include <cmath>

#include "contact/distance.hpp"

namespace corpuscle::contact {
namespace {

/// Node against triangle. Returns the distance; the normal stays zero if there is no way to tell
/// it.
double look_at_node(PairMemory& memory, const Points& x, double range, Contact& c) {
    const Vec3 &p = x[c.node[0]], &q0 = x[c.node[1]], &q1 = x[c.node[2]], &q2 = x[c.node[3]];
    const auto [region, w] = foot_on_triangle(p, q0, q1, q2);
    const Vec3 apart = p - w[0] * q0 - w[1] * q1 - w[2] * q2;
    const double distance = apart.norm();
    if (distance >= range) return distance;

    c.weight = {1.0, -w[0], -w[1], -w[2]};
    if (region == TriangleRegion::INSIDE) {
        const Vec3 area = (q1 - q0).cross(q2 - q0);
        const double signed_size = area.dot(apart);
        if (memory.side == 0) memory.side = signed_size > 0.0 ? 1 : signed_size < 0.0 ? -1 : 0;
        if (memory.side == 0) return distance;  // in the plane: which side is its own?
        c.normal = memory.side / area.norm() * area;
        c.gap = c.normal.dot(apart);
    } else {
        memory.side = 0;
        if (distance == 0.0) return distance;
        c.normal = apart / distance;
        c.gap = distance;
    }
    return distance;
}

/// Edge against edge, likewise.
double look_at_edges(PairMemory& memory, const Points& x, double range, Contact& c) {
    const Vec3 &p0 = x[c.node[0]], &p1 = x[c.node[1]], &q0 = x[c.node[2]], &q1 = x[c.node[3]];
    const auto [region, s, t] = feet_of_edges(p0, p1, q0, q1);
    const Vec3 apart = p0 + s * (p1 - p0) - q0 - t * (q1 - q0);
    const double distance = apart.norm();
    if (distance >= range) return distance;
    if (region != EdgeRegion::INSIDE) {
        memory.normal.setZero();
        return distance;
    }
    Vec3 normal = (p1 - p0).cross(q1 - q0).normalized();
    const double side = memory.normal.isZero() ? normal.dot(apart) : normal.dot(memory.normal);
    if (side == 0.0) return distance;
    if (side < 0.0) normal = -normal;
    memory.normal = normal;
    c.weight = {1.0 - s, s, t - 1.0, -t};
    c.normal = normal;
    c.gap = normal.dot(apart);
    return distance;
}

}  // namespace

bool look_at(Candidate& pair, const Points& x, double t, double growth_time, double range,
             double thickness, double& nearest, Contact& contact) {
    contact.node = pair.node;
    contact.normal.setZero();
    PairMemory& memory = pair.memory;
    nearest = pair.is_edges ? look_at_edges(memory, x, range, contact)
                            : look_at_node(memory, x, range, contact);
    if (nearest >= range) {
        memory = {};
        return false;
    }
    if (contact.normal.isZero()) return false;
    double missing = 0.0;
    if (memory.short_by > 0.0) {
        missing = memory.short_by * std::exp(-(t - memory.born) / growth_time);
        if (missing < 1e-6 * thickness) memory.short_by = missing = 0.0;
    }
    contact.rest = std::max(0.0, thickness - missing);
    contact.rest_rate = missing < thickness ? missing / growth_time : 0.0;
    return true;
}

}  // namespace corpuscle::contact
