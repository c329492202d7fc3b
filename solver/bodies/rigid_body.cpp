// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/rigid_body.hpp"

#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"
#include "solver/bodies/free_rotation.hpp"
#include "solver/bodies/rigid_parts.hpp"

namespace corpuscle {

RigidBody::RigidBody(const Model& model, Index part, const std::vector<double>& node_mass)
    : part_(part),
      id_(model.parts[part].id),
      parts_(merged_parts(model, part)),
      nodes_(nodes_of_rigid_parts(model, parts_)) {
    const auto& card =
        std::get<fabric::RigidCard>(model.materials[model.parts[part].material].card);
    fixed_moves_ = card.fixed_moves;
    fixed_turns_ = card.fixed_turns;
    fixed_axes_ = card.axes;
    set_inertia(inertia_of_parts(model, parts_, node_mass));
    for (const Index n : nodes_) arm_.push_back(turn_.conjugate() * (model.x[n] - centre_));
    next_centre_ = centre_;
    next_turn_ = turn_;

    for (const RigidVelocity& start : model.rigid_velocity)
        if (start.part == part) {
            velocity_ = start.velocity;
            const Vec3 local = turn_.conjugate() * start.spin;
            angular_momentum_ = turn_ * inertia_.cwiseProduct(local);
        }
    for (const PrescribedMotion& motion : model.motions)
        if (motion.rigid_part == part)
            motions_.push_back({motion.rotation,
                                motion.axis,
                                MotionCurve(motion, model.curves[motion.curve], model.end_time),
                                {}});
}

/// Principal moments and their axes.
void RigidBody::set_inertia(const RigidInertia& all) {
    mass_ = all.mass;
    centre_ = all.centre;
    if (!(mass_ > 0.0)) throw InputError(fmt::format("rigid part {} has no mass", id_));
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(all.inertia);
    Mat3 axes = principal.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
    turn_ = Eigen::Quaterniond(axes).normalized();
    inertia_ = principal_moments(principal.eigenvalues());
    if (!(inertia_.maxCoeff() > 0.0))
        throw InputError(fmt::format("rigid part {} has no moment of inertia", id_));
}

Vec3 RigidBody::spin_of(const Eigen::Quaterniond& turn, const Vec3& momentum) const {
    const Vec3 local = turn.conjugate() * momentum;
    return turn * spin_by(inertia_, local);
}

void RigidBody::advance(double t, double dt, double span, const Field& field,
                        fabric::Nodes& nodes) {
    arrive();
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (const Index n : nodes_) {
        force += nodes.f[n];
        torque += (nodes.x[n] - centre_).cross(nodes.f[n]);
    }
    torque += field.springs;
    const Vec3 zero = Vec3::Zero();
    kick_ = {t,
             span,
             force,
             torque,
             mass_ * field.acceleration + field.force,
             field.moment,
             -field.damping * mass_ * velocity_,
             -field.damping * angular_momentum_,
             spin(),
             kinetic_energy(),
             zero,
             zero};
    velocity_before_ = velocity_;
    momentum_before_ = angular_momentum_;
    velocity_ += span / mass_ * (force + kick_.weight + kick_.drag);
    angular_momentum_ += span * (torque + kick_.moment + kick_.turning_drag);
    drop_about_line();
    hold_translation(t, dt, span);
    hold_rotation(t, dt, span);
    if (span > 0.0) acceleration_ = (velocity_ - velocity_before_) / span;
    impulse_force_.setZero();
    book_kick();
    carry(dt, nodes);
}

void RigidBody::book_kick() {
    const Kick& k = kick_;
    mid_velocity_ = 0.5 * (velocity_before_ + velocity_);
    mid_spin_ = 0.5 * (k.spin + spin());
    field_work_ = k.span * (k.weight.dot(mid_velocity_) + k.moment.dot(mid_spin_));
    damped_ = -k.span * (k.drag.dot(mid_velocity_) + k.turning_drag.dot(mid_spin_));
    held_work_ = kinetic_energy() - k.kinetic - field_work_ + damped_ -
                 (k.span * k.force + k.joint_impulse).dot(mid_velocity_) -
                 (k.span * k.torque + k.joint_turning).dot(mid_spin_);
}

void RigidBody::pull(const contact::RigidProxy& proxy, const Vec3& impulse, const Vec3& turning,
                     double span, bool is_of_kick) {
    if (is_of_kick) {
        kick_.joint_impulse += impulse;
        kick_.joint_turning += turning;
    }
    give(proxy, impulse, turning, span);
}

/// Changes V and L by an impulse and its moment, and by what holds answer.
void RigidBody::give(const contact::RigidProxy& proxy, const Vec3& impulse, const Vec3& turning,
                     double span) {
    const Vec3 change = proxy.inverse_mass * impulse;
    velocity_ += change;
    if (held_turns_.empty()) {
        angular_momentum_ += turning;
        drop_about_line();
    } else {
        const Vec3 local = turn_.conjugate() * (spin() + proxy.inverse_inertia * turning);
        angular_momentum_ = turn_ * inertia_.cwiseProduct(local);
    }
    if (span > 0.0) acceleration_ += change / span;
}

/// What turns a line about itself turns nothing.
void RigidBody::drop_about_line() {
    if (inertia_.minCoeff() > 0.0) return;
    const Vec3 local = turn_.conjugate() * angular_momentum_;
    angular_momentum_ = turn_ * inertia_.cwiseProduct(spin_by(inertia_, local));
}

void RigidBody::foresee(double dt) {
    next_centre_ = centre_ + dt * velocity_;
    next_turn_ = turned(dt);
}

void RigidBody::carry(double dt, fabric::Nodes& nodes) {
    foresee(dt);
    const Mat3 turn = next_turn_.toRotationMatrix();
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        nodes.v[nodes_[i]] = (next_centre_ + turn * arm_[i] - nodes.x[nodes_[i]]) / dt;
}

Eigen::Quaterniond RigidBody::turned(double dt) const {
    if (angular_momentum_.isZero(0.0)) return turn_;
    const auto step = free_turn(inertia_, turn_.conjugate() * angular_momentum_, dt);
    if (!step)
        throw PhysicsError(kick_.t,
                           fmt::format("rigid part {} spins at {:.3g} rad/s, which no step "
                                       "of {:.3g} s can follow",
                                       id_, spin().norm(), dt));
    return (turn_ * *step).normalized();
}

/// About the centre, global axes. [1/(kg m^2)]
Mat3 RigidBody::inverse_inertia() const {
    const Mat3 R = turn_.toRotationMatrix();
    return R * spin_by(inertia_, Vec3::Ones()).asDiagonal() * R.transpose();
}

contact::RigidProxy RigidBody::proxy() const {
    contact::RigidProxy out;
    out.centre = centre_;
    Mat3 moves = Mat3::Identity();
    for (const Vec3& axis : held_moves_) moves -= axis * axis.transpose();
    out.inverse_mass = moves / mass_;
    out.inverse_inertia = turning_mobility();
    out.velocity = velocity_;
    out.spin = spin();
    out.held_velocity = velocity_ - moves * velocity_;
    if (!held_turns_.empty()) {
        // To a moment M the holds answer with -H (Hᵀ I⁻¹ H)⁻¹ Hᵀ I⁻¹ M, which works on the spin.
        const Mat3 R = turn_.toRotationMatrix();
        const Mat3 inertia = R * inertia_.asDiagonal() * R.transpose();
        out.held_spin = out.spin - out.inverse_inertia * (inertia * out.spin);
    }
    return out;
}

void RigidBody::take(const contact::RigidProxy& moved, const Vec3& by_joints, double dt,
                     double span, fabric::Nodes& nodes) {
    if (moved.impulse.isZero(0.0) && moved.turning.isZero(0.0)) return;
    give(moved, moved.impulse, moved.turning, span);
    if (span > 0.0) impulse_force_ = (moved.impulse - by_joints) / span;
    carry(dt, nodes);
}

Index body_of(const std::vector<RigidBody>& bodies, Index part) {
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const std::vector<Index>& parts = bodies[b].parts();
        if (std::find(parts.begin(), parts.end(), part) != parts.end())
            return static_cast<Index>(b);
    }
    return -1;
}

}  // namespace corpuscle
