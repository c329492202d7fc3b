// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Walls against rigid bodies: impulses on their nodes that move all of a body at once.

#include <algorithm>
#include <cmath>

#include "contact/rigid_walls/rigid_wall.hpp"

namespace corpuscle::contact {

namespace {

constexpr int SWEEPS = 50;        ///< a brick on its face settles to 1e-6 within some 20
constexpr double SETTLED = 1e-6;  ///< change of a speed in a sweep, of the fastest node's [-]
constexpr double REACH = 2.0;

}  // namespace

/// Planes before nodes of bodies: of those that would come in, and of those that might when the
/// body is turned by what others of its nodes feel.
double RigidWall::find_bumps(const Points& x, double dt, const Points& v,
                             const WallBodies& bodies) {
    bumps_.clear();
    if (!of_bodies_) {
        of_bodies_.emplace();
        for (std::size_t i = 0; i < card_.nodes.size(); ++i)
            if (bodies.has(card_.nodes[i])) of_bodies_->push_back(i);
    }
    double fastest = 0.0;
    const auto seen = [&](Index node) {
        return Vec3(v[node] + bodies.of(node).change_at(x[node]) - velocity_);
    };
    for (const std::size_t i : *of_bodies_)
        fastest = std::max(fastest, seen(card_.nodes[i]).norm());
    for (const std::size_t i : *of_bodies_) {
        const Index node = card_.nodes[i];
        const Vec3 at = x[node] - shift_, u = seen(node);
        auto plane = plane_before(i, at, dt * u);
        if (!plane && !is_behind_[i]) {
            const Nearby near = nearest(card_.shape, at);
            const bool is_free = near.normal.dot(u) >= -near.gap / dt;
            const bool is_open = std::holds_alternative<Plate>(card_.shape);
            if (is_free && !is_open && near.gap < REACH * dt * fastest)
                plane = Plane{near.normal, near.gap};
        }
        if (plane) bumps_.push_back({node, plane->normal, plane->gap / dt, 0.0, Vec3::Zero()});
    }
    return fastest;
}

/// Projected Gauss-Seidel on the impulses P_i >= 0 of all bumps:
///
///     n·(v + P / m - w) >= -gap / dt,   |friction| <= mu P,   1 / m = n·K n (+ 1 / M of the wall)
void RigidWall::stop_bodies(const Points& x, double dt, const Points& v, const WallBodies& bodies,
                            Vec3& impulse) {
    if (bodies.of_node.empty()) return;
    const double fastest = find_bumps(x, dt, v, bodies);
    const double own = card_.motion.mass;
    const auto seen = [&](const Bump& bump) {
        return Vec3(v[bump.node] + bodies.of(bump.node).change_at(x[bump.node]) - velocity_);
    };
    const auto mobility = [&](const Bump& bump, const Vec3& along) {
        const Mat3 K = bodies.of(bump.node).mobility(x[bump.node]);
        const double wall = own > 0.0 ? std::pow(along.dot(card_.motion.direction), 2) / own : 0.0;
        return along.dot(K * along) + wall;
    };
    // returns what the impulse takes from the energy that is seen from the wall
    const auto push = [&](const Bump& bump, const Vec3& by) {
        const Vec3 before = seen(bump);
        held_work_ += bodies.of(bump.node).push(by, x[bump.node]);
        impulse -= by;
        if (own > 0.0) velocity_ -= by.dot(card_.motion.direction) / own * card_.motion.direction;
        return -0.5 * by.dot(before + seen(bump));
    };
    // towards rest along the wall, as far as mu allows
    const auto rub = [&](Bump& bump) {
        if (card_.friction == 0.0) return 0.0;
        const Vec3 u = seen(bump), sliding = u - bump.normal.dot(u) * bump.normal;
        const double speed = sliding.norm();
        if (!(speed > 0.0)) return 0.0;
        const double yields = mobility(bump, sliding / speed);
        Vec3 wanted = bump.rubbed;
        if (yields > 0.0) wanted -= sliding / yields;
        const bool sticks = card_.friction == 1.0 && bump.taken > 0.0;
        const double most = sticks ? INF : card_.friction * bump.taken;
        if (const double size = wanted.norm(); size > most) wanted *= most / size;
        const Vec3 more = wanted - bump.rubbed;
        bump.rubbed = wanted;
        return push(bump, more);
    };
    for (int sweep = 0; sweep < SWEEPS; ++sweep) {
        double change = 0.0;
        for (Bump& bump : bumps_) {
            const double yields = mobility(bump, bump.normal);
            if (!(yields > 0.0)) continue;  // held: nothing stops it
            const double lack = -bump.gap_rate - bump.normal.dot(seen(bump));
            const double by = std::max(lack / yields, -bump.taken);
            bump.taken += by;
            stopping_energy_ += push(bump, by * bump.normal);
            change = std::max(change, std::abs(by) * yields);
            friction_energy_ += rub(bump);
        }
        if (change <= SETTLED * fastest) break;
    }
    for (const Bump& bump : bumps_)
        if (bump.taken > 0.0) touching_.push_back(bump.node);
}

}  // namespace corpuscle::contact
