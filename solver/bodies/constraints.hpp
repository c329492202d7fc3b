// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "fabric/nodes.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// A motion along one axis as the deck states it, turned into the velocity of a step.
class MotionCurve {
public:
    /// @param curve           of the motion, over time
    /// @param start_velocity  along the axis, of a prescribed acceleration                 [m/s]
    /// @param end_time        of the run, beyond which a curve that reaches it goes on       [s]
    MotionCurve(const PrescribedMotion& motion, const Curve& curve, double start_velocity,
                double end_time);

    /// Whether birth <= t < death.
    [[nodiscard]] bool is_active(double t) const { return t >= birth_ && t < death_; }

    /// Velocity that carries x(t) to x(t + dt): the exact displacement of the step over dt.   [m/s]
    /// `span` is the kick span at t, over which a prescribed acceleration acts.
    double velocity(double t, double dt, double span);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(velocity_);
    }

private:
    Curve curve_;
    MotionKind kind_;
    double scale_, birth_, death_;
    double velocity_;  ///< of a prescribed acceleration, integrated so far
};

/// Supports and prescribed motions of nodes. Rigid bodies have their own (rigid_body.hpp).
class Constraints {
public:
    /// @param model  whose supports and motions it takes, those of rigid parts left out
    explicit Constraints(const Model& model);

    /// Sets v(t + dt/2) of the held directions.
    /// @param span  of the kick at t                                                         [s]
    void hold(double t, double dt, double span, fabric::Nodes& nodes);

    /// Bits 0-2: directions x y z of a node that something holds, whatever the time.
    [[nodiscard]] const std::vector<std::uint8_t>& held() const { return held_; }
    /// Rows of the nodes that something holds.
    [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Motion& motion : motions_) archive(motion.curve);
    }

private:
    struct Motion {
        std::vector<Index> nodes;
        Vec3 axis;
        MotionCurve curve;
    };
    std::vector<Support> supports_;
    std::vector<Motion> motions_;
    std::vector<std::uint8_t> held_;
    std::vector<Index> nodes_;
};

}  // namespace corpuscle
