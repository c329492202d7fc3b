// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/rigid_body.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

#include "solver/base/error.hpp"

namespace corpuscle {
namespace {

std::vector<Index> nodes_of_part(const Model& model, Index part) {
    std::vector<Index> nodes;
    for (const Shell& shell : model.shells)
        if (shell.part == part) nodes.insert(nodes.end(), shell.nodes.begin(), shell.nodes.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

Eigen::Quaterniond turned(const Eigen::Quaterniond& from, const Vec3& spin, double dt) {
    const double angle = spin.norm() * dt;
    if (angle == 0.0) return from;
    const Eigen::Quaterniond step(Eigen::AngleAxisd(angle, spin.normalized()));
    return (step * from).normalized();
}

}  // namespace

RigidBody::RigidBody(const Model& model, Index part, const std::vector<double>& node_mass)
    : part_(part), nodes_(nodes_of_part(model, part)) {
    const auto& card =
        std::get<fabric::RigidCard>(model.materials[model.parts[part].material].card);
    fixed_moves_ = card.fixed_moves;
    fixed_turns_ = card.fixed_turns;

    centre_.setZero();
    for (const Index n : nodes_) {
        mass_ += node_mass[n];
        centre_ += node_mass[n] * model.x[n];
    }
    if (!(mass_ > 0.0))
        throw InputError(fmt::format("rigid part {} has no mass", model.parts[part].id));
    centre_ /= mass_;
    Mat3 inertia = Mat3::Zero();
    for (const Index n : nodes_) {
        const Vec3 r = model.x[n] - centre_;
        inertia += node_mass[n] * (r.squaredNorm() * Mat3::Identity() - r * r.transpose());
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> principal(inertia);
    Mat3 axes = principal.eigenvectors();
    if (axes.determinant() < 0.0) axes.col(2) = -axes.col(2);
    turn_ = Eigen::Quaterniond(axes).normalized();
    // A straight row of nodes has no moment about itself; then nothing can turn it, nor does it
    // matter.
    inertia_ = principal.eigenvalues().cwiseMax(1e-12 * principal.eigenvalues().maxCoeff());
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
        if (motion.rigid_part == part) {
            const double start =
                motion.rotation ? spin_of(turn_).dot(motion.axis) : velocity_.dot(motion.axis);
            motions_.push_back({motion.rotation, motion.axis,
                                MotionCurve(motion, model.curves[motion.curve], start)});
        }
}

Vec3 RigidBody::spin_of(const Eigen::Quaterniond& turn) const {
    const Vec3 local = turn.conjugate() * angular_momentum_;
    return turn * local.cwiseQuotient(inertia_);
}

void RigidBody::advance(double t, double dt, double span, fabric::Nodes& nodes) {
    centre_ = next_centre_;
    turn_ = next_turn_;
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
    for (const Index n : nodes_) {
        force += nodes.f[n];
        torque += (nodes.x[n] - centre_).cross(nodes.f[n]);
    }
    const Vec3 before = velocity_;
    velocity_ += span / mass_ * force;
    angular_momentum_ += span * torque;
    hold_translation(t, dt, span);
    if (span > 0.0) acceleration_ = (velocity_ - before) / span;

    Vec3 spin = spin_of(turn_);
    for (int sweep = 0; sweep < 2; ++sweep) spin = spin_of(turned(turn_, spin, 0.5 * dt));
    hold_rotation(t, dt, span, spin);

    next_centre_ = centre_ + dt * velocity_;
    next_turn_ = turned(turn_, spin, dt);
    for (std::size_t i = 0; i < nodes_.size(); ++i)
        nodes.v[nodes_[i]] = (next_centre_ + next_turn_ * arm_[i] - nodes.x[nodes_[i]]) / dt;
}

void RigidBody::hold_translation(double t, double dt, double span) {
    for (int a = 0; a < 3; ++a)
        if (fixed_moves_ & (1U << a)) velocity_[a] = 0.0;
    for (Motion& motion : motions_) {
        if (motion.rotation || !motion.curve.is_active(t)) continue;
        const double target = motion.curve.velocity(t, dt, span);
        velocity_ += (target - velocity_.dot(motion.axis)) * motion.axis;
    }
}

void RigidBody::hold_rotation(double t, double dt, double span, Vec3& spin) {
    bool held = false;
    for (int a = 0; a < 3; ++a)
        if (fixed_turns_ & (1U << a)) {
            spin[a] = 0.0;
            held = true;
        }
    for (Motion& motion : motions_) {
        if (!motion.rotation || !motion.curve.is_active(t)) continue;
        const double target = motion.curve.velocity(t, dt, span);
        spin += (target - spin.dot(motion.axis)) * motion.axis;
        held = true;
    }
    if (!held) return;
    const Vec3 local = turn_.conjugate() * spin;
    angular_momentum_ = turn_ * inertia_.cwiseProduct(local);
}

}  // namespace corpuscle
