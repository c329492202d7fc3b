// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "fabric/nodes.hpp"
#include "solver/constraints.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// A *MAT_RIGID part: six degrees of freedom, mass and inertia from its nodes' lumped masses.
///
/// Leapfrog on the centre of mass and on the angular momentum L; the spin of a step comes from L
/// and the orientation at mid-step, found by two fixed-point sweeps (free rotation keeps L
/// exactly).
class RigidBody {
public:
    RigidBody(const Model& model, Index part, const std::vector<double>& node_mass);

    /// v, L at t - dt/2 -> t + dt/2 from the forces on its nodes; then sets its nodes' v so that a
    /// drift over dt carries them to the body's place at t + dt.
    void advance(double t, double dt, double span, fabric::Nodes& nodes);

    [[nodiscard]] Index part() const { return part_; }
    [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }
    [[nodiscard]] bool is_driven() const { return !motions_.empty(); }
    [[nodiscard]] const Vec3& position() const { return centre_; }    ///< of the mass centre, at t
    [[nodiscard]] const Vec3& velocity() const { return velocity_; }  ///< at t + dt/2
    [[nodiscard]] const Vec3& acceleration() const { return acceleration_; }
    [[nodiscard]] double mass() const { return mass_; }
    [[nodiscard]] const Vec3& angular_momentum() const { return angular_momentum_; }

private:
    struct Motion {
        bool rotation;
        Vec3 axis;
        MotionCurve curve;
    };
    Vec3 spin_of(const Eigen::Quaterniond& turn) const;
    void hold_translation(double t, double dt, double span);
    void hold_rotation(double t, double dt, double span, Vec3& spin);

    Index part_;
    std::vector<Index> nodes_;
    std::vector<Vec3> arm_;  ///< node - centre in the body's axes                   [m]
    double mass_ = 0.0;      ///< [kg]
    Vec3 inertia_;           ///< principal moments                                  [kg m^2]
    unsigned fixed_moves_ = 0, fixed_turns_ = 0;
    std::vector<Motion> motions_;

    Vec3 centre_;  ///< at t, moved to t + dt by the next advance
    Vec3 next_centre_;
    Eigen::Quaterniond turn_, next_turn_;
    Vec3 velocity_ = Vec3::Zero();
    Vec3 acceleration_ = Vec3::Zero();
    Vec3 angular_momentum_ = Vec3::Zero();
};

}  // namespace corpuscle
