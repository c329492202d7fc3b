// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Linear and angular momentum, about the origin of coordinates.
struct Wrench {
    Vec3 linear = Vec3::Zero();   ///< momentum, or an impulse               [N s]
    Vec3 angular = Vec3::Zero();  ///< its moment about the origin         [N m s]
    /// Adds both, about the same origin.
    Wrench& operator+=(const Wrench& o) {
        linear += o.linear;
        angular += o.angular;
        return *this;
    }
    /// Takes off both.
    Wrench& operator-=(const Wrench& o) {
        linear -= o.linear;
        angular -= o.angular;
        return *this;
    }
    /// Multiplies both.                                                                       [-]
    Wrench& operator*=(double factor) {
        linear *= factor;
        angular *= factor;
        return *this;
    }
    /// Adds an impulse [N s] that acts at a place [m], and its moment about the origin.
    void add(const Vec3& at, const Vec3& impulse) {
        linear += impulse;
        angular += at.cross(impulse);
    }
    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(linear, angular);
    }
};

}  // namespace corpuscle::gas
