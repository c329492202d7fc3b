// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <optional>
#include <vector>

#include "contact/surface/rigid_proxies.hpp"
#include "fabric/nodes.hpp"
#include "solver/bodies/constraints.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// A *MAT_RIGID part, or a lead part and those that are merged with it: six degrees of freedom.
/// Mass and inertia are those of all of them (rigid_parts.hpp); supports, motions and initial
/// velocity the lead's.
///
/// Leapfrog on the centre of mass and on the angular momentum L about it. Orientation R follows by
/// free_turn(), which keeps L and the energy of free rotation to rounding, at second order in the
/// phase. A body whose mass is a straight line has no spin about it, and no moment about it acts.
class RigidBody {
public:
    /// @throws InputError for a body without mass
    RigidBody(const Model& model, Index part, const std::vector<double>& node_mass);

    /// What acts on a body as a whole.
    struct Field {
        Vec3 acceleration = Vec3::Zero();  ///< of all its matter  [m/s^2]
        double damping = 0.0;              ///< by mass, *DAMPING_GLOBAL [1/s]
        Vec3 force = Vec3::Zero(),         ///< *LOAD_RIGID_BODY: at the mass centre          [N]
            moment = Vec3::Zero();         ///< *LOAD_RIGID_BODY                            [N m]
        Vec3 springs = Vec3::Zero();       ///< moment of springs of joints                 [N m]
    };
    /// Is at t, where its nodes have been carried.
    void arrive() {
        centre_ = next_centre_;
        turn_ = next_turn_;
    }
    /// V, L at t - dt/2 -> t + dt/2 from the forces on its nodes; then carries its nodes.
    void advance(double t, double dt, double span, const Field& field, fabric::Nodes& nodes);

    /// As contact sees it at t: with the velocity before advance() or after it.
    [[nodiscard]] contact::RigidProxy proxy() const;
    /// Takes what contact has given in the step from t to t + dt, and carries its nodes anew.
    /// @param by_joints  of the impulse that it has taken, what joints passed on         [N s]
    void take(const contact::RigidProxy& moved, const Vec3& by_joints, double dt, double span,
              fabric::Nodes& nodes);

    /// What a joint gives between the kick and the drift (rigid_joints.hpp): changes V and L, and
    /// where foresee() says that the body goes; carry() then moves the nodes.
    /// @param proxy       what holds leave of it, as proxy() said
    /// @param turning     moment of the impulse about the centre                       [N m s]
    /// @param is_of_kick  it acts with the forces of the kick, and book_kick() knows it
    void pull(const contact::RigidProxy& proxy, const Vec3& impulse, const Vec3& turning,
              double span, bool is_of_kick);
    /// Finds where V and L lead the centre and the orientation at t + dt.
    void foresee(double dt);
    /// foresee(), and gives each node the velocity that brings it there.                    [m/s]
    void carry(double dt, fabric::Nodes& nodes);
    void book_kick();  ///< work of the last kick, with what joints gave

    /// A place of the body in its own axes, from where it is at t.                         [m]
    [[nodiscard]] Vec3 arm_of(const Vec3& x) const { return turn_.conjugate() * (x - centre_); }
    /// Where a place of the body is at t.                                                   [m]
    [[nodiscard]] Vec3 at(const Vec3& arm) const { return centre_ + turn_ * arm; }
    /// Where it is at t + dt.                                                               [m]
    [[nodiscard]] Vec3 then(const Vec3& arm) const { return next_centre_ + next_turn_ * arm; }

    /// Row of the part that leads.
    [[nodiscard]] Index part() const { return part_; }
    /// Rows of the part and of all that are merged with it.
    [[nodiscard]] const std::vector<Index>& parts() const { return parts_; }
    /// Rows of the nodes that ride on it.
    [[nodiscard]] const std::vector<Index>& nodes() const { return nodes_; }
    /// Of the mass centre, at t.                                                            [m]
    [[nodiscard]] const Vec3& position() const { return centre_; }
    /// Of the mass centre, at t + dt/2.                                                   [m/s]
    [[nodiscard]] const Vec3& velocity() const { return velocity_; }
    /// Of the mass centre: change of velocity by the last kick, joints and contact, over the kick's
    /// span.                                                                               [m/s^2]
    [[nodiscard]] const Vec3& acceleration() const { return acceleration_; }
    /// Not all of its translations are fixed.
    [[nodiscard]] bool can_move() const { return fixed_moves_ != 7U; }
    /// Not all of its rotations are fixed.
    [[nodiscard]] bool can_turn() const { return fixed_turns_ != 7U; }
    /// Of all its parts.                                                                      [kg]
    [[nodiscard]] double mass() const { return mass_; }
    /// L about the mass centre, at t + dt/2, global axes.                              [kg m^2/s]
    [[nodiscard]] const Vec3& angular_momentum() const { return angular_momentum_; }
    /// Angular velocity of L at the orientation of t.                                   [rad/s]
    [[nodiscard]] Vec3 spin() const { return spin_of(turn_, angular_momentum_); }
    /// R at t: from the principal axes of inertia to the global ones.
    [[nodiscard]] const Eigen::Quaterniond& turn() const { return turn_; }

    [[nodiscard]] double kinetic_energy() const {  ///< at t + dt/2                         [J]
        return energy_of(velocity_, angular_momentum_);
    }
    /// At t, between those before and after the last kick and what contact gave then.
    /// @param weight  of the half step after t, Clock::weight()                            [-]
    [[nodiscard]] Vec3 velocity_at_t(double weight) const {
        return velocity_before_ + weight * (velocity_ - velocity_before_);
    }
    /// L at t, likewise.                                                              [kg m^2/s]
    [[nodiscard]] Vec3 angular_momentum_at_t(double weight) const {
        return momentum_before_ + weight * (angular_momentum_ - momentum_before_);
    }
    /// Of a place of the body at t, likewise.                                             [m/s]
    [[nodiscard]] Vec3 velocity_at_t(const Vec3& x, double weight) const {
        return velocity_at_t(weight) +
               spin_of(turn_, angular_momentum_at_t(weight)).cross(x - centre_);
    }
    /// At t, of both.                                                                       [J]
    [[nodiscard]] double kinetic_energy_at_t(double weight) const {
        return energy_of(velocity_at_t(weight), angular_momentum_at_t(weight));
    }
    /// Velocity of a place, mean of before and after the last kick: with it the work of forces on
    /// the body is exactly what they change of its kinetic energy.
    [[nodiscard]] Vec3 mid_velocity_at(const Vec3& x) const {
        return mid_velocity_ + mid_spin_.cross(x - centre_);
    }
    /// Spin, the same mean.                                                            [rad/s]
    [[nodiscard]] const Vec3& mid_spin() const { return mid_spin_; }
    /// By supports and prescribed motions in the last kick.                                 [J]
    [[nodiscard]] double held_work() const { return held_work_; }
    /// By the field's acceleration, force and moment in the last kick.                       [J]
    [[nodiscard]] double field_work() const { return field_work_; }
    /// What the field's damping took in the last kick.                                       [J]
    [[nodiscard]] double damped() const { return damped_; }
    /// Mean of what contact's impulses gave in the last step, that of joints left out.     [N]
    [[nodiscard]] const Vec3& impulse_force() const { return impulse_force_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Motion& motion : motions_) archive(motion.led);
        archive(held_moves_, held_turns_, centre_, next_centre_, turn_, next_turn_, velocity_,
                acceleration_, angular_momentum_, mid_velocity_, mid_spin_, impulse_force_,
                held_work_, field_work_, damped_);
    }

private:
    struct Motion {
        bool rotation;
        Vec3 axis;
        MotionCurve curve;
        std::optional<double> led;  ///< rate about or along the axis, by a prescribed acceleration
                                    ///< that has acted                            [rad/s], [m/s]
    };
    void set_inertia(const RigidInertia& all);
    void drop_about_line();
    void give(const contact::RigidProxy& proxy, const Vec3& impulse, const Vec3& turning,
              double span);
    [[nodiscard]] Vec3 spin_of(const Eigen::Quaterniond& turn, const Vec3& momentum) const;
    [[nodiscard]] double energy_of(const Vec3& velocity, const Vec3& angular_momentum) const {
        return 0.5 * mass_ * velocity.squaredNorm() +
               0.5 * angular_momentum.dot(spin_of(turn_, angular_momentum));
    }
    [[nodiscard]] Eigen::Quaterniond turned(double dt) const;
    struct Holds {
        std::vector<Vec3> axes;         ///< independent
        std::vector<Vec3> orthonormal;  ///< that span the same
        std::vector<double> rates;      ///< along the axes
    };
    [[nodiscard]] double rate_of(Motion& motion, double t, double dt, double span) const;
    [[nodiscard]] Holds holds(bool rotation, double t, double dt, double span);
    void hold_translation(double t, double dt, double span);
    void hold_rotation(double t, double dt, double span);
    [[nodiscard]] Mat3 inverse_inertia() const;
    [[nodiscard]] Mat3 turning_mobility() const;

    Index part_;
    int id_;                    ///< the part's
    std::vector<Index> parts_;  ///< rows
    std::vector<Index> nodes_;
    std::vector<Vec3> arm_;  ///< node - centre in the body's axes                   [m]
    double mass_ = 0.0;      ///< [kg]
    Vec3 inertia_;           ///< principal_moments()                                [kg m^2]
    unsigned fixed_moves_ = 0, fixed_turns_ = 0;  ///< along the columns of fixed_axes_
    Mat3 fixed_axes_;
    std::vector<Motion> motions_;
    std::vector<Vec3> held_moves_, held_turns_;  ///< axes along which it is held now, independent;
                                                 ///< those of moves orthonormal

    Vec3 centre_;       ///< at t, or where the last step began until arrive()        [m]
    Vec3 next_centre_;  ///< where that step leads: centre_ from arrive() on            [m]
    Eigen::Quaterniond turn_, next_turn_;  ///< R, likewise
    Vec3 velocity_ = Vec3::Zero();
    Vec3 acceleration_ = Vec3::Zero();
    Vec3 angular_momentum_ = Vec3::Zero();
    Vec3 velocity_before_ = Vec3::Zero(), momentum_before_ = Vec3::Zero();  ///< at t - dt/2
    Vec3 mid_velocity_ = Vec3::Zero(), mid_spin_ = Vec3::Zero();
    Vec3 impulse_force_ = Vec3::Zero();
    double held_work_ = 0.0, field_work_ = 0.0, damped_ = 0.0;

    struct Kick {                           ///< the last one
        double t = 0.0;                     ///< [s]
        double span = 0.0;                  ///< [s]
        Vec3 force, torque;                 ///< on the nodes, and of springs         [N], [N m]
        Vec3 weight, moment;                ///< of the field                      [N], [N m]
        Vec3 drag, turning_drag;            ///< [N], [N m]
        Vec3 spin;                          ///< before it                              [rad/s]
        double kinetic = 0.0;               ///< before it                                  [J]
        Vec3 joint_impulse, joint_turning;  ///< [N s], [N m s]
    };
    Kick kick_;
};

/// Row of the body that a part is of; -1: of none.
[[nodiscard]] Index body_of(const std::vector<RigidBody>& bodies, Index part);

}  // namespace corpuscle
