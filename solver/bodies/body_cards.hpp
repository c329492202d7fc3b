// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

/// @file
/// What a scene says of its rigid bodies and of what joins them.

namespace corpuscle {

/// Initial velocity of a rigid part.
struct RigidVelocity {
    Index part = -1;               ///< row of a *MAT_RIGID part
    Vec3 velocity = Vec3::Zero();  ///< of the centre of mass          [m/s]
    Vec3 spin = Vec3::Zero();      ///< angular velocity               [rad/s]
};

/// *PART_INERTIA, or the solids of a rigid part: its mass, whatever its shells would weigh.
struct RigidInertia {
    Index part = -1;              ///< row of a *MAT_RIGID part
    double mass = NaN;            ///< of the part                                [kg]
    Vec3 centre = Vec3::Zero();   ///< of mass, at the start                     [m]
    Mat3 inertia = Mat3::Zero();  ///< about the centre, global axes             [kg m^2]
};

/// *CONSTRAINED_EXTRA_NODES: a node that rides on a rigid part without being one of its shells'.
struct RigidExtraNode {
    Index part = -1;  ///< row of a *MAT_RIGID part
    Index node = -1;  ///< row among the nodes
};

/// *CONSTRAINED_RIGID_BODIES: two *MAT_RIGID parts that move as one body, the lead's.
struct RigidMerge {
    Index lead = -1,             ///< row of the part that leads
        part = -1;               ///< row of the part that goes with it
    bool keeps_inertia = false;  ///< the lead's *PART_INERTIA holds for both, IFLAG = 0
};

/// *CONSTRAINED_JOINT_SPHERICAL, _REVOLUTE: two rigid parts share a place, or two places and with
/// them an axis.
struct RigidJoint {
    std::array<Index, 2> parts{-1, -1};  ///< rows of *MAT_RIGID parts
    std::vector<Vec3> places;            ///< one or two, at the start                       [m]
    std::string name;                    ///< for messages: "*CONSTRAINED_JOINT_REVOLUTE 3"
};

/// What acts about one angle q of *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED, against it:
///
///     M = spring(q) + damper(q') + ES (q - nearest of [low, high]) + friction,
///
/// friction = ES (q - q_p), which slips (q_p moves) where it would go beyond FM.
struct JointAxis {
    Index spring = -1,         ///< curve: moment over angle              [N m] over [rad]; -1: none
        damper = -1;           ///< curve: moment over its rate         [N m] over [rad/s]; -1: none
    double stiffness = 0.0,    ///< ES: of stops and friction                            [N m/rad]
        friction = 0.0;        ///< FM                                                       [N m]
    double low = -INF,         ///< stop below 0                                             [rad]
        high = INF;            ///< stop above 0                                             [rad]
    bool is_mirrored = false;  ///< the angle counts the other way, in a mirror image
};

/// *CONSTRAINED_JOINT_STIFFNESS_GENERALIZED: moments between two bodies, beside any joint.
struct JointStiffness {
    int id = 0;                          ///< JSID
    std::array<Index, 2> parts{-1, -1};  ///< rows of *MAT_RIGID parts, A and B
    /// Of both at the start, local x, y, z as columns.
    std::array<Mat3, 2> axes{Mat3::Identity(), Mat3::Identity()};
    std::array<JointAxis, 3> about;  ///< phi, theta, psi: Cardan angles x, y, z of B's axes in A's
};

}  // namespace corpuscle
