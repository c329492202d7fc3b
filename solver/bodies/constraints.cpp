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

MotionCurve::MotionCurve(const PrescribedMotion& motion, const Curve& curve, double end_time)
    : curve_(curve.continued_beyond(end_time)),
      kind_(motion.kind),
      scale_(motion.scale),
      birth_(motion.birth),
      death_(motion.death) {}

double MotionCurve::velocity(double t, double dt) const {
    return kind_ == MotionKind::VELOCITY ? scale_ * curve_.mean(t, t + dt)
                                         : scale_ * (curve_(t + dt) - curve_(t)) / dt;
}

Constraints::Constraints(const Model& model) : held_(model.x.size(), 0) {
    for (const Support& support : model.supports) {
        if ((support.fixed & 7U) == 0) continue;  // membranes have no rotations to hold
        supports_.push_back(support);
        held_[support.node] |= static_cast<std::uint8_t>(support.fixed & 7U);
    }
    for (const PrescribedMotion& motion : model.motions) {
        if (motion.rigid_part >= 0) continue;
        motions_.push_back({motion.nodes,
                            motion.axis,
                            MotionCurve(motion, model.curves[motion.curve], model.end_time),
                            {}});
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

void Constraints::hold(double t, double dt, double span, const Points& before,
                       fabric::Nodes& nodes) {
    for (const Support& support : supports_)
        for (int a = 0; a < 3; ++a)
            if (support.fixed & (1U << a)) nodes.v[support.node][a] = 0.0;
    for (Motion& motion : motions_)
        if (motion.curve.is_active(t)) move(motion, t, dt, span, before, nodes.v);
}

void Constraints::move(Motion& motion, double t, double dt, double span, const Points& before,
                       Points& v) {
    const auto lead = [&](Index node, double target) {
        v[node] += (target - v[node].dot(motion.axis)) * motion.axis;
    };
    if (!motion.curve.is_acceleration()) {
        const double target = motion.curve.velocity(t, dt);
        for (const Index node : motion.nodes) lead(node, target);
        return;
    }
    if (motion.led.empty())
        for (const Index node : motion.nodes) motion.led.push_back(before[node].dot(motion.axis));
    const double gain = motion.curve.gain(t, span);
    for (std::size_t k = 0; k < motion.nodes.size(); ++k)
        lead(motion.nodes[k], motion.led[k] += gain);
}

}  // namespace corpuscle
