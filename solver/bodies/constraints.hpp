// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "fabric/nodes.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// A motion along one axis as the deck states it, turned into velocities of a step. What a
/// prescribed acceleration has led to is its user's to keep: each node and body has its own.
class MotionCurve {
public:
    /// @param curve     of the motion, over time
    /// @param end_time  of the run, beyond which a curve that reaches it goes on             [s]
    MotionCurve(const PrescribedMotion& motion, const Curve& curve, double end_time);

    /// Whether birth <= t < death.
    [[nodiscard]] bool is_active(double t) const { return t >= birth_ && t < death_; }
    /// Whether it gives an acceleration, and gain() counts; else velocity() does.
    [[nodiscard]] bool is_acceleration() const { return kind_ == MotionKind::ACCELERATION; }

    /// Velocity that carries x(t) to x(t + dt): the exact displacement of the step over dt.   [m/s]
    [[nodiscard]] double velocity(double t, double dt) const;
    /// Velocity that a prescribed acceleration gives in the kick at t, over its span.         [m/s]
    [[nodiscard]] double gain(double t, double span) const { return scale_ * curve_(t) * span; }

private:
    Curve curve_;
    MotionKind kind_;
    double scale_, birth_, death_;
};

/// Supports and prescribed motions of nodes. Rigid bodies have their own (rigid_body.hpp).
class Constraints {
public:
    /// @param model  whose supports and motions it takes, those of rigid parts left out
    explicit Constraints(const Model& model);

    /// Sets v(t + dt/2) of the held directions. A prescribed acceleration begins with the velocity
    /// that each node has along the axis before the first kick in which it acts.
    /// @param span    of the kick at t                                                       [s]
    /// @param before  velocities before it, N × 3                                          [m/s]
    void hold(double t, double dt, double span, const Points& before, fabric::Nodes& nodes);

    /// Bits 0-2: directions x y z of a node that something holds, whatever the time.
    [[nodiscard]] const std::vector<std::uint8_t>& held() const { return held_; }
    /// Rows of the nodes that something holds.
    [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Motion& motion : motions_) archive(motion.led);
    }

private:
    struct Motion {
        std::vector<Index> nodes;
        Vec3 axis;
        MotionCurve curve;
        std::vector<double> led;  ///< by node: along the axis, by a prescribed acceleration [m/s];
                                  ///< empty before it acts
    };
    void move(Motion& motion, double t, double dt, double span, const Points& before, Points& v);

    std::vector<Support> supports_;
    std::vector<Motion> motions_;
    std::vector<std::uint8_t> held_;
    std::vector<Index> nodes_;
};

}  // namespace corpuscle
