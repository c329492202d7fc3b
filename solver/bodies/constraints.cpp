// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/constraints.hpp"

namespace corpuscle {
namespace {

/// Directions that an axis holds completely: those of a coordinate axis, none of an oblique one.
std::uint8_t directions(const Vec3& axis) {
    for (int a = 0; a < 3; ++a)
        if (std::abs(std::abs(axis[a]) - 1.0) < 1e-12) return static_cast<std::uint8_t>(1U << a);
    return 0;
}

}  // namespace

MotionCurve::MotionCurve(const PrescribedMotion& motion, const Curve& curve, double start_velocity,
                         double end_time)
    : curve_(curve.continued_beyond(end_time)),
      kind_(motion.kind),
      scale_(motion.scale),
      birth_(motion.birth),
      death_(motion.death),
      velocity_(start_velocity) {}

double MotionCurve::velocity(double t, double dt, double span) {
    switch (kind_) {
        case MotionKind::VELOCITY:
            return scale_ * curve_.mean(t, t + dt);
        case MotionKind::DISPLACEMENT:
            return scale_ * (curve_(t + dt) - curve_(t)) / dt;
        case MotionKind::ACCELERATION:
            break;
    }
    return velocity_ += scale_ * curve_(t) * span;
}

Constraints::Constraints(const Model& model) : held_(model.x.size(), 0) {
    for (const Support& support : model.supports) {
        if ((support.fixed & 7U) == 0) continue;  // membranes have no rotations to hold
        supports_.push_back(support);
        held_[support.node] |= static_cast<std::uint8_t>(support.fixed & 7U);
    }
    for (const PrescribedMotion& motion : model.motions) {
        if (motion.rigid_part >= 0) continue;
        const double start =
            motion.nodes.empty() ? 0.0 : model.velocity[motion.nodes.front()].dot(motion.axis);
        motions_.push_back(
            {motion.nodes, motion.axis,
             MotionCurve(motion, model.curves[motion.curve], start, model.end_time)});
        if (motion.birth <= 0.0 && motion.death >= model.end_time)
            for (const Index node : motion.nodes) held_[node] |= directions(motion.axis);
    }
    std::vector<bool> seen(model.x.size(), false);
    for (const Support& support : supports_) seen[support.node] = true;
    for (const Motion& motion : motions_)
        for (const Index node : motion.nodes) seen[node] = true;
    for (std::size_t n = 0; n < seen.size(); ++n)
        if (seen[n]) nodes_.push_back(static_cast<Index>(n));
}

void Constraints::hold(double t, double dt, double span, fabric::Nodes& nodes) {
    for (const Support& support : supports_)
        for (int a = 0; a < 3; ++a)
            if (support.fixed & (1U << a)) nodes.v[support.node][a] = 0.0;
    for (Motion& motion : motions_) {
        if (!motion.curve.is_active(t)) continue;
        const double target = motion.curve.velocity(t, dt, span);
        for (const Index node : motion.nodes)
            nodes.v[node] += (target - nodes.v[node].dot(motion.axis)) * motion.axis;
    }
}

}  // namespace corpuscle
