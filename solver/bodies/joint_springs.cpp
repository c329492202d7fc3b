// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/joint_springs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"

namespace corpuscle {
namespace {

constexpr double NEAR_GIMBAL = 0.05;  ///< |cos theta| below which phi and psi are not told apart
constexpr double IN_GIMBAL = 1e-9;    ///< the same, of rounding
constexpr double DEGREES = 180.0 / std::numbers::pi;

/// The angle that differs from another one by full turns, nearest to a third.
double unwound(double angle, double near) {
    constexpr double TURN = 2.0 * std::numbers::pi;
    return angle + TURN * std::round((near - angle) / TURN);
}

/// phi, theta, psi of R = Rx Ry Rz, of all that give this R those nearest to `before`.
Vec3 cardan_angles(const Mat3& R, const Vec3& before) {
    const double cosine = std::hypot(R(0, 0), R(0, 1));
    Vec3 first(before[0], std::atan2(R(0, 2), cosine), before[2]);
    if (cosine > IN_GIMBAL) {
        first[0] = std::atan2(-R(1, 2), R(2, 2));
        first[2] = std::atan2(-R(0, 1), R(0, 0));
    }
    Vec3 second = cosine > IN_GIMBAL ? Vec3(first + Vec3::Constant(std::numbers::pi)) : first;
    second[1] = std::numbers::pi - first[1];
    for (int k = 0; k < 3; ++k) {
        first[k] = unwound(first[k], before[k]);
        second[k] = unwound(second[k], before[k]);
    }
    return (first - before).norm() <= (second - before).norm() ? first : second;
}

/// d_k, columns in A's axes; those of phi and psi are 0 in gimbal lock.
Mat3 duals_of(const Vec3& q) {
    const double s = std::sin(q[0]), c = std::cos(q[0]), cosine = std::cos(q[1]);
    Mat3 duals = Mat3::Zero();
    duals.col(1) = Vec3(0.0, c, s);
    if (std::abs(cosine) <= IN_GIMBAL) return duals;
    const double tangent = std::sin(q[1]) / cosine;
    duals.col(0) = Vec3(1.0, s * tangent, -c * tangent);
    duals.col(2) = Vec3(0.0, -s, c) / cosine;
    return duals;
}

double steepest_slope(const Curve& curve) {
    double steepest = 0.0;
    for (std::size_t i = 1; i < curve.x.size(); ++i)
        if (curve.x[i] > curve.x[i - 1])
            steepest = std::max(
                steepest, std::abs(curve.y[i] - curve.y[i - 1]) / (curve.x[i] - curve.x[i - 1]));
    return steepest;
}

/// Of a curve from 0 to u.
double work_to(const Curve& curve, double u) {
    return u == 0.0 ? 0.0 : u * curve.mean(std::min(u, 0.0), std::max(u, 0.0));
}

}  // namespace

/// Moment of spring, stops and friction; what they hold is added to, and slip moves on.
double JointSprings::About::held(double u, double& stored, double& rubbed) {
    double moment = 0.0;
    if (!spring.empty()) {
        moment += spring(u);
        stored += work_to(spring, u);
    }
    const double beyond = u - std::clamp(u, card.low, card.high);
    moment += card.stiffness * beyond;
    stored += 0.5 * card.stiffness * beyond * beyond;
    if (!(card.friction > 0.0 && card.stiffness > 0.0)) return moment;
    const double most = card.friction / card.stiffness;
    const double sticking = std::clamp(u - slipped, -most, most);
    rubbed += card.friction * std::abs(u - slipped - sticking);
    slipped = u - sticking;
    stored += 0.5 * card.stiffness * sticking * sticking;
    return moment + card.stiffness * sticking;
}

JointSprings::JointSprings(const Model& model, const std::vector<RigidBody>& bodies)
    : moment_(bodies.size(), Vec3::Zero()) {
    const auto curve = [&](Index row) { return row < 0 ? Curve{} : model.curves[row]; };
    for (const JointStiffness& card : model.joint_stiffnesses) {
        Pair pair;
        pair.id = card.id;
        for (std::size_t k = 0; k < 2; ++k) pair.bodies[k] = body_of(bodies, card.parts[k]);
        if (pair.bodies[0] < 0 || pair.bodies[1] < 0 || pair.bodies[0] == pair.bodies[1])
            throw InputError(
                fmt::format("joint stiffness {}: of one body with itself, expected two", card.id));
        for (std::size_t k = 0; k < 2; ++k)
            pair.axes[k] = bodies[pair.bodies[k]].turn().conjugate() * card.axes[k];
        for (std::size_t k = 0; k < 3; ++k) {
            const JointAxis& axis = card.about[k];
            About& about = pair.about[k] = {axis, curve(axis.spring), curve(axis.damper)};
            const bool has_stop = axis.low > -INF || axis.high < INF;
            about.steepest = steepest_slope(about.spring) + (has_stop ? axis.stiffness : 0.0) +
                             (axis.friction > 0.0 ? axis.stiffness : 0.0);
            about.viscous = steepest_slope(about.damper);
        }
        if (!look(pair, bodies))
            throw InputError(fmt::format(
                "joint stiffness {}: theta is {:.4g} degrees at the start, expected axes that are "
                "further from 90, where phi and psi are not told apart",
                card.id, pair.angles[1] * DEGREES));
        for (int k = 0; k < 3; ++k)
            pair.about[k].slipped = (pair.about[k].card.is_mirrored ? -1.0 : 1.0) * pair.angles[k];
        pairs_.push_back(std::move(pair));
    }
}

Mat3 JointSprings::axes_of(const Pair& pair, int side, const std::vector<RigidBody>& bodies) {
    return bodies[pair.bodies[side]].turn() * pair.axes[side];
}

/// Angles of now. @returns whether the laws can tell them apart
bool JointSprings::look(Pair& pair, const std::vector<RigidBody>& bodies) {
    const Mat3 R = axes_of(pair, 0, bodies).transpose() * axes_of(pair, 1, bodies);
    pair.angles = cardan_angles(R, pair.angles);
    pair.duals = duals_of(pair.angles);
    return std::abs(std::cos(pair.angles[1])) > NEAR_GIMBAL ||
           (pair.about[0].is_free() && pair.about[2].is_free());
}

void JointSprings::find(double t, const std::vector<RigidBody>& bodies) {
    std::fill(moment_.begin(), moment_.end(), Vec3::Zero());
    for (Pair& pair : pairs_) {
        if (!look(pair, bodies))
            throw PhysicsError(
                t, fmt::format("joint stiffness {}: theta comes to {:.4g} degrees, where phi and "
                               "psi are not told apart",
                               pair.id, pair.angles[1] * DEGREES));
        const Mat3 axes = axes_of(pair, 0, bodies);
        const auto [a, b] = pair.bodies;
        const Vec3 rates =
            pair.duals.transpose() * (axes.transpose() * (bodies[b].spin() - bodies[a].spin()));
        Vec3 held = Vec3::Zero(), damping = Vec3::Zero();
        pair.stored = 0.0;
        for (int k = 0; k < 3; ++k) {
            About& about = pair.about[k];
            const double sign = about.card.is_mirrored ? -1.0 : 1.0;
            held[k] = sign * about.held(sign * pair.angles[k], pair.stored, pair.rubbed);
            if (!about.damper.empty()) damping[k] = sign * about.damper(sign * rates[k]);
        }
        pair.damping = -(axes * (pair.duals * damping));
        const Vec3 on_b = pair.damping - axes * (pair.duals * held);
        moment_[b] += on_b;
        moment_[a] -= on_b;
    }
}

double JointSprings::damped(double span, const std::vector<RigidBody>& bodies) const {
    double taken = 0.0;
    for (const Pair& pair : pairs_)
        taken -= span * pair.damping.dot(bodies[pair.bodies[1]].mid_spin() -
                                         bodies[pair.bodies[0]].mid_spin());
    return taken;
}

double JointSprings::energy() const {
    double all = 0.0;
    for (const Pair& pair : pairs_) all += pair.stored;
    return all;
}

double JointSprings::rubbed() const {
    double all = 0.0;
    for (const Pair& pair : pairs_) all += pair.rubbed;
    return all;
}

JointSprings::Limit JointSprings::stable_step(const std::vector<RigidBody>& bodies) const {
    std::vector<Mat3> mobility;  // spin by a moment, by body
    for (const RigidBody& body : bodies) mobility.push_back(body.proxy().inverse_inertia);
    std::vector<std::array<double, 2>> own;  // K, C by pair
    for (const Pair& pair : pairs_) {
        const Mat3 axes = axes_of(pair, 0, bodies);
        std::array<double, 2> sums{};
        for (int k = 0; k < 3; ++k) {
            const Vec3 d = axes * pair.duals.col(k);
            const double gives = d.dot((mobility[pair.bodies[0]] + mobility[pair.bodies[1]]) * d);
            sums[0] += pair.about[k].steepest * gives;
            sums[1] += pair.about[k].viscous * gives;
        }
        own.push_back(sums);
    }
    Limit limit;
    for (std::size_t p = 0; p < pairs_.size(); ++p) {
        double K = 0.0, C = 0.0;
        for (std::size_t other = 0; other < pairs_.size(); ++other) {
            const auto& theirs = pairs_[other].bodies;
            const auto is_shared = [&](Index body) {
                return !mobility[body].isZero(0.0) && (theirs[0] == body || theirs[1] == body);
            };
            if (other != p && !is_shared(pairs_[p].bodies[0]) && !is_shared(pairs_[p].bodies[1]))
                continue;
            K += own[other][0];
            C += own[other][1];
        }
        const double dt = 4.0 / (C + std::sqrt(C * C + 4.0 * K));  // INF: nothing acts
        if (dt < limit.dt) limit = {dt, pairs_[p].id};
    }
    return limit;
}

}  // namespace corpuscle
