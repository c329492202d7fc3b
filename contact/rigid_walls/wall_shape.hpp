// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "solver/base/vec.hpp"

/// @file
/// Convex shapes of rigid walls, in closed form: how far a point is, where a path leads in.
///
/// Ranges (low, high) may be endless; axes are unit vectors.

namespace corpuscle::contact {

/// All that lies behind a plane.
struct HalfSpace {
    Vec3 point = Vec3::Zero();    ///< on the plane                                          [m]
    Vec3 normal = Vec3::UnitZ();  ///< nodes live on this side
};

/// A rectangle without depth; it has a front, and its back lets everything pass.
struct Plate {
    Vec3 corner = Vec3::Zero();    ///< where both ranges are 0  [m]
    Mat3 axes = Mat3::Identity();  ///< columns: two edges, normal
    double low[2] = {-INF, -INF},  ///< begin along each of the two edges, from the corner  [m]
        high[2] = {INF, INF};      ///< end, likewise  [m]
};

/// A ball, inside and rim.
struct Ball {
    Vec3 centre = Vec3::Zero();  ///< of the ball  [m]
    double radius = NaN;         ///< of its rim  [m]
};

/// A round cylinder with flat ends.
struct Rod {
    Vec3 base = Vec3::Zero();   ///< on the axis  [m]
    Vec3 axis = Vec3::UnitZ();  ///< unit
    double radius = NaN;        ///< of the mantle  [m]
    double low = -INF,          ///< lower end along the axis, from the base  [m]
        high = INF;             ///< upper end, likewise  [m]
};

/// A brick.
struct Brick {
    Vec3 corner = Vec3::Zero();       ///< where all ranges are 0  [m]
    Mat3 axes = Mat3::Identity();     ///< columns: three edges, unit
    Vec3 low = Vec3::Constant(-INF),  ///< begin along each axis, from the corner  [m]
        high = Vec3::Constant(INF);   ///< end, likewise  [m]
};

/// One of the shapes; the functions below take any.
using WallShape = std::variant<HalfSpace, Plate, Ball, Rod, Brick>;

/// Of a point: its distance from the shape, below 0 inside, and the outward normal there. Of a
/// plate: the height above its plane.
struct Nearby {
    double gap = INF;            ///< distance, < 0 inside  [m]
    Vec3 normal = Vec3::Zero();  ///< outward, unit; where several are as near, one of them
};
/// Distance and normal at a place, in closed form.                                         [m]
[[nodiscard]] Nearby nearest(const WallShape& shape, const Vec3& at);

/// Where a straight path leads in: the share of the path, and the outward normal there.
struct Entry {
    double share = 0.0;          ///< 0 to 1  [-]
    Vec3 normal = Vec3::Zero();  ///< outward, unit, at the entry
};
/// The first entry of the path from a place outside to another; none where it stays outside.
/// A plate is entered from its front only.
[[nodiscard]] std::optional<Entry> entry(const WallShape& shape, const Vec3& from, const Vec3& to);

/// Does the place lie above or below the rectangle?
[[nodiscard]] bool covers(const Plate& plate, const Vec3& at);

/// Normal of a wall that is plane; 0 of one that is not.
[[nodiscard]] Vec3 plane_normal(const WallShape& shape);

}  // namespace corpuscle::contact
