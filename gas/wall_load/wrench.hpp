// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// Linear and angular momentum, about the origin of coordinates.
struct Wrench {
    Vec3 linear = Vec3::Zero();   ///< [N s]
    Vec3 angular = Vec3::Zero();  ///< [N m s]
    Wrench& operator+=(const Wrench& o) {
        linear += o.linear;
        angular += o.angular;
        return *this;
    }
    Wrench& operator-=(const Wrench& o) {
        linear -= o.linear;
        angular -= o.angular;
        return *this;
    }
    Wrench& operator*=(double factor) {
        linear *= factor;
        angular *= factor;
        return *this;
    }
    void add(const Vec3& at, const Vec3& impulse) {
        linear += impulse;
        angular += at.cross(impulse);
    }
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(linear, angular);
    }
};

}  // namespace corpuscle::gas
