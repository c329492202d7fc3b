// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What holds and leads rigid bodies.

#include <Eigen/Cholesky>

#include "solver/bodies/rigid_body.hpp"

namespace corpuscle {
namespace {

/// b, less what it has along the axes.
Vec3 without(const std::vector<Vec3>& axes, Vec3 b) {
    for (const Vec3& axis : axes) b -= axis.dot(b) * axis;
    return b;
}

/// Axes made orthonormal; those that add nothing are left out.
void add_axis(std::vector<Vec3>& axes, const Vec3& axis) {
    const Vec3 rest = without(axes, axis);
    if (rest.norm() > 1e-9) axes.push_back(rest.normalized());
}

/// Up to three axes as columns.
using Axes = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

Axes columns(const std::vector<Vec3>& axes) {
    Axes out(3, static_cast<Eigen::Index>(axes.size()));
    for (std::size_t k = 0; k < axes.size(); ++k) out.col(static_cast<Eigen::Index>(k)) = axes[k];
    return out;
}

Eigen::Map<const Eigen::VectorXd> wanted(const std::vector<double>& target) {
    return {target.data(), static_cast<Eigen::Index>(target.size())};
}

}  // namespace

/// Spin by a moment, with what the holds along H answer: I⁻¹ - I⁻¹ H (Hᵀ I⁻¹ H)⁻¹ Hᵀ I⁻¹.
Mat3 RigidBody::turning_mobility() const {
    const Mat3 inverse = inverse_inertia();
    if (held_turns_.empty()) return inverse;
    if (held_turns_.size() == 3) return Mat3::Zero();
    const Axes H = columns(held_turns_);
    const Axes IH = inverse * H;
    // none about a line: then the holds have nothing to answer there
    return inverse - IH * (H.transpose() * IH).ldlt().solve(IH.transpose());
}

/// Of a motion that acts; a prescribed acceleration begins with what the body has before the kick.
double RigidBody::rate_of(Motion& motion, double t, double dt, double span) const {
    if (!motion.curve.is_acceleration()) return motion.curve.velocity(t, dt);
    if (!motion.led)
        motion.led = (motion.rotation ? kick_.spin : velocity_before_).dot(motion.axis);
    return *motion.led += motion.curve.gain(t, span);
}

/// What holds translation, or rotation, now; motions go before fixed axes along which they lead.
RigidBody::Holds RigidBody::holds(bool rotation, double t, double dt, double span) {
    Holds now;
    const auto hold = [&](const Vec3& axis, double rate) {
        const std::size_t before = now.orthonormal.size();
        add_axis(now.orthonormal, axis);
        if (now.orthonormal.size() == before) return;  // held already
        now.axes.push_back(axis);
        now.rates.push_back(rate);
    };
    for (Motion& motion : motions_)
        if (motion.rotation == rotation && motion.curve.is_active(t))
            hold(motion.axis, rate_of(motion, t, dt, span));
    const unsigned fixed = rotation ? fixed_turns_ : fixed_moves_;
    for (int a = 0; a < 3; ++a)
        if (fixed & (1U << a)) hold(fixed_axes_.col(a), 0.0);
    return now;
}

/// V by the impulses of the holds, along their axes H alone: Hᵀ (V + H m) = what they hold.
void RigidBody::hold_translation(double t, double dt, double span) {
    const Holds now = holds(false, t, dt, span);
    held_moves_ = now.orthonormal;
    if (now.axes.empty()) return;
    const Axes H = columns(now.axes);
    velocity_ +=
        H * (H.transpose() * H).ldlt().solve(wanted(now.rates) - H.transpose() * velocity_);
}

/// L by the moments of the holds, along their axes H alone: Hᵀ I⁻¹ (L + H m) = what they hold.
void RigidBody::hold_rotation(double t, double dt, double span) {
    const Holds now = holds(true, t, dt, span);
    held_turns_ = now.axes;
    if (now.axes.empty()) return;
    const Axes H = columns(now.axes);
    const Mat3 inverse = inverse_inertia();
    const Eigen::VectorXd moment =
        (H.transpose() * inverse * H)
            .ldlt()
            .solve(wanted(now.rates) - H.transpose() * (inverse * angular_momentum_));
    angular_momentum_ += H * moment;
}

}  // namespace corpuscle
