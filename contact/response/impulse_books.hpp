// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Energy that the impulses of one card have taken from the motion since the start.
struct ImpulseBooks {
    double friction = 0.0;   ///< rubbed away                                                  [J]
    double normal = 0.0;     ///< pressed in less given back, damped, stopped short of crossing  [J]
    double held_work = 0.0;  ///< given by what is held, which impulses do not move            [J]
    Vec3 given = Vec3::Zero();  ///< in the last step: to SURFA, or of a single surface to the
                                ///< free nodes [N s]

    ImpulseBooks& operator+=(const ImpulseBooks& other) {
        friction += other.friction;
        normal += other.normal;
        held_work += other.held_work;
        given += other.given;
        return *this;
    }
};

}  // namespace corpuscle::contact
