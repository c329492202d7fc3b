// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "solver/base/curve.hpp"
#include "solver/bodies/rigid_body.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Springs, dampers, stops and friction between pairs of rigid bodies, over the angles phi, theta,
/// psi of B's axes in A's,
///
///     AᵀB = Rx(phi) Ry(theta) Rz(psi),   q_k' = d_k · w,   T_B = -T_A = -sum M_k d_k,
///
/// w the spin of B less that of A, d_k the rows of the inverse of w = sum w_k q_k' (Cardan angles;
/// d_k = e_k where the others are 0). Thus T·w is the power of the moments, what they do is kept as
/// energy or lost, and the pair's angular momentum stays. M_k is as JointAxis says.
class JointSprings {
public:
    /// @param bodies  of the scene, where they are at the start
    /// @throws InputError  for a pair that moves as one body, and one that starts near theta = 90°
    JointSprings(const Model& model, const std::vector<RigidBody>& bodies);

    /// Finds the moments at t, of the angles then and of the spins before the kick; once a step.
    /// @throws PhysicsError  where theta comes near 90°, unless phi and psi are free
    void find(double t, const std::vector<RigidBody>& bodies);
    /// On a body at t, of all its springs; by row.                                         [N m]
    [[nodiscard]] const Vec3& moment(std::size_t body) const { return moment_[body]; }

    /// What dampers took in the last kick.                                                   [J]
    [[nodiscard]] double damped(double span, const std::vector<RigidBody>& bodies) const;
    /// What springs, stops and friction hold at t, 0 of a spring at an angle of 0.           [J]
    [[nodiscard]] double energy() const;
    /// What friction has taken up to t.                                                      [J]
    [[nodiscard]] double rubbed() const;

    /// Longest stable step, and the id of the stiffest pair.
    struct Limit {
        double dt = INF;  ///< [s]
        int id = 0;       ///< JSID
    };
    /// dt² K + 2 dt C <= 4, with K = sum of M_k' d_k·(I_A⁻¹ + I_B⁻¹) d_k by the steepest slopes, C
    /// likewise of dampers, both summed over the pairs that share a body.
    [[nodiscard]] Limit stable_step(const std::vector<RigidBody>& bodies) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Pair& pair : pairs_) {
            archive(pair.angles, pair.duals, pair.stored, pair.rubbed);
            for (About& axis : pair.about) archive(axis.slipped);
        }
    }

private:
    /// One angle's law, for u = ± q.
    struct About {
        JointAxis card;
        Curve spring, damper;
        double slipped = 0.0;   ///< u at which friction holds nothing            [rad]
        double steepest = 0.0,  ///< greatest dM/du                          [N m/rad]
            viscous = 0.0;      ///< greatest dM/du'                       [N m s/rad]
        [[nodiscard]] bool is_free() const {
            return spring.empty() && damper.empty() && steepest == 0.0;
        }
        [[nodiscard]] double held(double u, double& stored, double& rubbed);
    };
    struct Pair {
        int id = 0;
        std::array<Index, 2> bodies{-1, -1};
        std::array<Mat3, 2> axes;  ///< in the bodies' own axes
        std::array<About, 3> about;
        Vec3 angles = Vec3::Zero();     ///< phi, theta, psi                               [rad]
        Mat3 duals = Mat3::Identity();  ///< d_k as columns, in A's axes
        double stored = 0.0, rubbed = 0.0;
        Vec3 damping = Vec3::Zero();  ///< of T_B, what dampers give                     [N m]
    };
    static Mat3 axes_of(const Pair& pair, int side, const std::vector<RigidBody>& bodies);
    static bool look(Pair& pair, const std::vector<RigidBody>& bodies);

    std::vector<Pair> pairs_;
    std::vector<Vec3> moment_;  ///< by body                                               [N m]
};

}  // namespace corpuscle
