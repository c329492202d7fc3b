// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/surface/cloth.hpp"
#include "contact/surface/contact_list.hpp"

namespace corpuscle::contact {

/// Energy that the impulses of one card have taken from the motion since the start.
struct ImpulseBooks {
    double friction = 0.0;   ///< rubbed away                                                  [J]
    double normal = 0.0;     ///< pressed in less given back, damped, stopped short of crossing  [J]
    double held_work = 0.0;  ///< given by what is held, which impulses do not move            [J]
    Vec3 given = Vec3::Zero();  ///< in the last step: to SURFA, or of a single surface to the
                                ///< free nodes [N s]

    /// Notes what a contact's first place has got.                                          [N s]
    void give(const Vec3& impulse, const Contact& c, const Cloth& cloth) {
        if (c.side != 0) given += c.side * impulse;
        for (int k = 0; k < 4 && c.side == 0; ++k)
            if (cloth.inverse_mass[c.node[k]] > 0.0) given += c.weight[k] * impulse;
    }
    ImpulseBooks& operator+=(const ImpulseBooks& other) {
        friction += other.friction;
        normal += other.normal;
        held_work += other.held_work;
        given += other.given;
        return *this;
    }
};

}  // namespace corpuscle::contact
