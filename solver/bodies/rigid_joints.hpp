// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Cholesky>

#include <array>
#include <string>
#include <vector>

#include "contact/surface/rigid_proxies.hpp"
#include "fabric/nodes.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Joints of rigid bodies, held exactly: impulses J at the joints' places x(t) such that at t + dt
/// the two bodies have them in one place again [SHAKE; Ryckaert, Ciccotti & Berendsen 1977],
///
///     d_i · (x_A - x_B)(t + dt) = 0,   S J = -gap / dt,   S_ij = d_i · (sum of mobilities) d_j,
///
/// by Newton's method to rounding. d_i: three directions at a joint's first place, two across its
/// axis at a second one. What one body gets the other gives, at one place: momentum and angular
/// momentum are kept. No stiffness and no damping.
class RigidJoints {
public:
    /// @throws InputError  for a joint whose two parts move as one body
    RigidJoints(const Model& model, const std::vector<RigidBody>& bodies);

    /// Whether the model has none.
    [[nodiscard]] bool empty() const { return pins_.empty(); }

    /// What hold() follows in a step.
    enum class After {
        KICK,    ///< RigidBody::advance(), whose work is booked anew
        CONTACT  ///< RigidBody::take()
    };
    /// Pulls bodies together and carries their nodes, after a kick, whose work is booked anew, or
    /// after they have taken what contact gave.
    /// @throws PhysicsError  where holds keep a joint's bodies apart
    /// @param proxies  by body, as it is now; gets what it is after a kick
    void hold(double t, double dt, double span, After after, std::vector<RigidBody>& bodies,
              std::vector<contact::RigidProxy>& proxies, fabric::Nodes& nodes);

    /// What contact has given to a body since hold() is passed on, as far as velocities show it.
    /// @returns  work that supports and motions do thereby                                  [J]
    double pass_on(std::vector<contact::RigidProxy>& proxies);
    /// What pass_on() has given to a body since hold() after the kick: of what the body's proxy has
    /// taken, the part that is not contact's.                                             [N s]
    [[nodiscard]] const Vec3& passed_on(std::size_t body) const { return passed_on_[body]; }

    /// By joint: the number that its name ends with; where two end with the same, the order of the
    /// deck from 1.
    [[nodiscard]] std::vector<int> ids() const;

    /// What a joint has given to the body of its first node, about the joint's first place.
    struct Given {
        Vec3 impulse = Vec3::Zero();  ///< [N s]
        Vec3 turning = Vec3::Zero();  ///< [N m s]
    };
    /// By joint, since this was asked for last.
    [[nodiscard]] std::vector<Given> take_given();

private:
    struct Pin {
        std::array<Index, 2> bodies{-1, -1};
        std::array<Vec3, 2> arms;   ///< in the bodies' axes                                 [m]
        std::size_t joint = 0;      ///< that it is of
        int rows = 3;               ///< 2: across the axis through this pin and the one before
        Vec3 place = Vec3::Zero();  ///< at t                                         [m]
        std::array<Vec3, 3> directions{};  ///< unit
        std::string name;
    };
    void look(const std::vector<RigidBody>& bodies);
    void factor(const std::vector<contact::RigidProxy>& proxies);
    template <class Give>
    void share(const Eigen::VectorXd& impulse, Give&& give);

    std::vector<Pin> pins_;
    std::vector<Given> given_;  ///< by joint
    Points passed_on_;          ///< by body                                            [N s]
    Eigen::Index rows_ = 0;
    Eigen::LDLT<Eigen::MatrixXd> mobility_;  ///< S of the last hold()                    [1/kg]
};

}  // namespace corpuscle
