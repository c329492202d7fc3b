// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "contact/rigid_walls/wall_shape.hpp"

namespace corpuscle::contact {

/// How a wall moves: not at all, as a curve says, at a constant speed, or as a free mass.
struct WallMotion {
    Vec3 direction = Vec3::Zero();  ///< unit; 0: the wall stands still
    Index curve = -1;               ///< curve row, over the time since birth; -1: none
    bool is_displacement = false;   ///< the curve gives a displacement, else a speed   [m, m/s]
    double speed = 0.0;             ///< V0, without a curve                          [m/s]
    double mass = 0.0;              ///< MASS, without a curve: 0 is not to be slowed down  [kg]
};

/// *RIGIDWALL_PLANAR, *RIGIDWALL_GEOMETRIC: something hard that nodes cannot enter.
struct WallCard {
    int id = 0;                ///< RWID, else order in the deck from 1
    std::string title;         ///< from the deck, may be empty
    WallShape shape;           ///< at the start
    WallMotion motion;         ///< from birth on
    double friction = 0.0;     ///< FRIC: 0 slides, 1 sticks, else Coulomb     [-]
    std::vector<Index> nodes;  ///< node rows that it stops
    double birth = 0.0,        ///< before it the wall is not there  [s]
        death = INF;           ///< after it the wall is not there  [s]
};

}  // namespace corpuscle::contact
