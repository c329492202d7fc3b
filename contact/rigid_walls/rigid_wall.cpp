// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/rigid_walls/rigid_wall.hpp"

#include <algorithm>

#include "contact/geometry/box.hpp"

namespace corpuscle::contact {
namespace {

constexpr double NEAR_STEPS = 4.0;  ///< displacements of that many steps are near

}  // namespace

RigidWall::RigidWall(const WallCard& card, const Curve* curve, double end_time) : card_(card) {
    const WallMotion& motion = card_.motion;
    if (curve != nullptr) curve_ = curve->continued_beyond(end_time - card_.birth);
    if (!curve_)
        velocity_ = (card_.birth > 0.0 ? 0.0 : motion.speed) * motion.direction;
    else if (motion.is_displacement)
        shift_ = next_shift_ = (*curve_)(0.0) * motion.direction;
    stops_.reserve(card_.nodes.size());
    touching_.reserve(card_.nodes.size());
}

void RigidWall::hold(const Points& x, std::span<const double> mass, double t, double dt, Points& v,
                     const WallBodies& bodies) {
    velocity_before_ = velocity_;
    set_out(t, dt);
    if (t <= 0.0) velocity_before_ = velocity_;  // a driven wall has its speed from the start
    stops_.clear();
    touching_.clear();
    Vec3 impulse = Vec3::Zero();
    impulse_.setZero();
    near_.clear();
    if (is_on(t)) {
        if (is_behind_.size() != card_.nodes.size()) note_nodes_behind(x);
        find_stops(x, dt, v, bodies);
        slow_down(mass);
        find_near(x, dt, v);
        stop(mass, v, impulse);
        stop_bodies(x, dt, v, bodies, impulse);
    }
    take(impulse, dt);
}

void RigidWall::hold_again(bool is_whole, const Points& x, std::span<const double> mass, double t,
                           double dt, Points& v, const WallBodies& bodies) {
    if (!is_on(t)) return;
    stops_.clear();
    if (is_whole)
        find_stops(x, dt, v, bodies);
    else
        for (const std::size_t i : near_)
            if (const auto stop = stop_of(i, x, dt, v, bodies)) stops_.push_back(*stop);
    if (stops_.empty()) return;
    Vec3 impulse = Vec3::Zero();
    slow_down(mass);
    stop(mass, v, impulse);
    take(impulse, dt);
}

/// Books what the wall has got.
void RigidWall::take(const Vec3& impulse, double dt) {
    if (!(card_.motion.mass > 0.0)) driving_work_ -= impulse.dot(velocity_);
    impulse_ += impulse;
    force_ = impulse_ / dt;
    if (!curve_) next_shift_ = shift_ + dt * velocity_;
}

/// Nodes that a few steps could bring to the wall.
void RigidWall::find_near(const Points& x, double dt, const Points& v) {
    found_near_.find(card_.nodes.size(), near_, [&](std::size_t i, auto&& take) {
        const Index node = card_.nodes[i];
        const double reach = NEAR_STEPS * dt * (v[node] - velocity_).norm();
        if (nearest(card_.shape, x[node] - shift_).gap <= reach) take(i);
    });
}

/// Takes the place that the last step led to, and the velocity of the next one: exactly the path
/// that a curve gives for it.
void RigidWall::set_out(double t, double dt) {
    shift_ = next_shift_;
    if (!curve_) return launch(t, dt);
    const WallMotion& motion = card_.motion;
    const double from = std::max(t - card_.birth, 0.0), to = std::max(t + dt - card_.birth, 0.0);
    double travel = 0.0;
    if (t < card_.death && to > from)
        travel = motion.is_displacement ? (*curve_)(to) - (*curve_)(from)
                                        : curve_->mean(from, to) * (to - from);
    velocity_ = travel / dt * motion.direction;
    next_shift_ = shift_ + travel * motion.direction;
}

/// Gives a wall without a curve V0 at its birth, and before it the part of the step ahead in which
/// it is born; the energy that its mass gets thereby is driving work.
void RigidWall::launch(double t, double dt) {
    if (!is_behind_.empty()) return;  // it has been there before
    const double share = t >= card_.birth ? 1.0 : std::max(0.0, t + dt - card_.birth) / dt;
    driving_work_ -= kinetic_energy();
    velocity_ = share * card_.motion.speed * card_.motion.direction;
    driving_work_ += kinetic_energy();
}

/// Of coordinates in decks, of seven digits: a millionth of what the nodes extend over.      [m]
double RigidWall::rounding(const Points& x) const {
    Box all;
    for (const Index node : card_.nodes) all.include(x[node]);
    return card_.nodes.empty() ? 0.0 : 1e-6 * (all.high - all.low).norm();
}

RigidWall::Inside RigidWall::inside(const Points& x) const {
    Inside out;
    const auto* plate = std::get_if<Plate>(&card_.shape);
    const double least = rounding(x);
    for (const Index node : card_.nodes) {
        const double depth = -nearest(card_.shape, x[node] - shift_).gap;
        if (!(depth > least) || (plate != nullptr && !covers(*plate, x[node] - shift_))) continue;
        ++out.nodes;
        if (depth > out.depth) out = {out.nodes, node, depth};
    }
    return out;
}

void RigidWall::note_nodes_behind(const Points& x) {
    const bool is_plate = std::holds_alternative<Plate>(card_.shape);
    const double least = rounding(x);
    for (const Index node : card_.nodes) {
        const Vec3 at = x[node] - shift_;
        is_behind_.push_back(nearest(card_.shape, at).gap < -least);
        if (is_plate) last_.push_back(at);
    }
}

/// Is the node one of those that are let alone? A node gets behind a plate round its edges; one
/// that something else has driven through it is still in front.
bool RigidWall::passes(std::size_t i, const Vec3& at, double gap) {
    if (gap >= 0.0) is_behind_[i] = 0;
    if (const auto* plate = std::get_if<Plate>(&card_.shape)) {
        if (gap < 0.0 && !is_behind_[i]) {
            const bool came_through = nearest(card_.shape, last_[i]).gap < 0.0
                                          ? covers(*plate, at)
                                          : entry(card_.shape, last_[i], at).has_value();
            is_behind_[i] = !came_through;
        }
        last_[i] = at;
    }
    return is_behind_[i] != 0;
}

/// The plane that keeps the node out, if its path leads in.
std::optional<RigidWall::Plane> RigidWall::plane_before(std::size_t i, const Vec3& at,
                                                        const Vec3& travel) {
    const Nearby now = nearest(card_.shape, at);
    if (passes(i, at, now.gap)) return {};
    if (now.gap <= 0.0) return Plane{now.normal, now.gap};
    const auto in = entry(card_.shape, at, at + travel);
    if (!in) return {};
    return Plane{in->normal, -in->share * in->normal.dot(travel)};
}

void RigidWall::find_stops(const Points& x, double dt, const Points& v, const WallBodies& bodies) {
    found_stops_.find(card_.nodes.size(), stops_, [&](std::size_t i, auto&& take) {
        if (const auto stop = stop_of(i, x, dt, v, bodies)) take(*stop);
    });
}

std::optional<RigidWall::Stop> RigidWall::stop_of(std::size_t i, const Points& x, double dt,
                                                  const Points& v, const WallBodies& bodies) {
    const Index node = card_.nodes[i];
    if (bodies.has(node)) return {};
    const auto plane = plane_before(i, x[node] - shift_, dt * (v[node] - velocity_));
    if (!plane) return {};
    const double spare = plane->normal.dot(v[node]) + plane->gap / dt;
    if (!(spare < plane->normal.dot(velocity_))) return {};
    return Stop{node, plane->normal, spare, false};
}

/// The common speed of a wall that has mass and of the nodes that it meets: the root of
///
///     M (w - w_0) + sum m max(0, w - spare) = 0
///
/// by Newton's method, which comes down to it without overshooting, for the sum is convex.
void RigidWall::slow_down(std::span<const double> mass) {
    const double own = card_.motion.mass;
    if (!(own > 0.0) || stops_.empty()) return;
    const Vec3& along = card_.motion.direction;
    const double first = velocity_.dot(along);
    double speed = first;
    for (bool is_found = false; !is_found;) {
        double sum = own, momentum = own * first;
        for (const Stop& stop : stops_) {
            if (stop.spare >= speed) continue;
            sum += mass[stop.node];
            momentum += mass[stop.node] * stop.spare;
        }
        is_found = !(momentum / sum < speed);
        if (!is_found) speed = momentum / sum;
    }
    velocity_ = speed * along;
    stopping_energy_ += 0.5 * own * (first - speed) * (first - speed);
}

void RigidWall::stop(std::span<const double> mass, Points& v, Vec3& impulse) {
    constexpr std::size_t A_CHUNK = 64;
    struct Taken {
        double stopping = 0.0, friction = 0.0;  ///< [J]
        Vec3 impulse = Vec3::Zero();
    };
    const auto stop_one = [&](Taken& taken, std::size_t i) {
        Stop& stop = stops_[i];
        const double push = stop.normal.dot(velocity_) - stop.spare;
        stop.has_met = push > 0.0;  // else the wall was slowed down before it met this node
        if (!stop.has_met) return;
        Vec3& now = v[stop.node];
        const double m = mass[stop.node];
        // as seen from the wall
        const Vec3 before = now - velocity_;
        const Vec3 slid = before + push * stop.normal;
        const Vec3 after = rubbed(slid, stop.normal, push);
        taken.stopping += 0.5 * m * (before.squaredNorm() - slid.squaredNorm());
        taken.friction += 0.5 * m * (slid.squaredNorm() - after.squaredNorm());
        taken.impulse += m * (before - after);
        now = after + velocity_;
    };
    const Taken all = parallel::fold(
        stops_.size(), Taken{}, stop_one,
        [](Taken& sum, const Taken& own) {
            sum.stopping += own.stopping;
            sum.friction += own.friction;
            sum.impulse += own.impulse;
        },
        A_CHUNK);
    stopping_energy_ += all.stopping;
    friction_energy_ += all.friction;
    impulse += all.impulse;
    for (const Stop& stop : stops_)
        if (stop.has_met) touching_.push_back(stop.node);
}

/// Velocity after friction, `stop` being the normal velocity that the wall took away.
Vec3 RigidWall::rubbed(const Vec3& v, const Vec3& normal, double stop) const {
    const Vec3 off = normal.dot(v) * normal;
    const Vec3 sliding = v - off;
    const double speed = sliding.norm();
    if (card_.friction == 1.0 || speed <= card_.friction * stop) return off;
    return off + (1.0 - card_.friction * stop / speed) * sliding;
}

double RigidWall::kinetic_energy() const {
    return 0.5 * card_.motion.mass * velocity_.squaredNorm();
}

}  // namespace corpuscle::contact
