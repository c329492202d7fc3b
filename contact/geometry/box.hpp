// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Axis-aligned box, closed: boxes that touch overlap. Empty at first, from INF to -INF.       [m]
struct Box {
    Vec3 low = Vec3::Constant(INF);    ///< least coordinates
    Vec3 high = Vec3::Constant(-INF);  ///< greatest coordinates

    /// Grows it to hold a point.
    void include(const Vec3& p) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    /// Grows it to hold another box; an empty one adds nothing.
    void include(const Box& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
    }
    /// Moves each of the six faces outwards; inwards for a negative margin.                   [m]
    void inflate(double margin) {
        low.array() -= margin;
        high.array() += margin;
    }
    /// Whether the two share a point; an empty box shares none.
    [[nodiscard]] bool overlaps(const Box& other) const {
        // no branches: of the boxes that are compared most do not overlap, in no predictable
        // direction
        return (low.x() <= other.high.x()) & (low.y() <= other.high.y()) &
               (low.z() <= other.high.z()) & (other.low.x() <= high.x()) &
               (other.low.y() <= high.y()) & (other.low.z() <= high.z());
    }
};

}  // namespace corpuscle::contact
