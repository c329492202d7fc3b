// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Axis-aligned box, closed: boxes that touch overlap.                                      [m]
struct Box {
    Vec3 low = Vec3::Constant(INF);
    Vec3 high = Vec3::Constant(-INF);

    void include(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    void include(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    void inflate(double margin) {
        low.array() -= margin;
        high.array() += margin;
    }
    [[nodiscard]] bool overlaps(const Box& other) const {
        // no branches: of the boxes that are compared most do not overlap, in no predictable
        // direction
        return (low.x() <= other.high.x()) & (low.y() <= other.high.y()) &
               (low.z() <= other.high.z()) & (other.low.x() <= high.x()) &
               (other.low.y() <= high.y()) & (other.low.z() <= high.z());
    }
};

}  // namespace corpuscle::contact
