// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <variant>

#include "solver/base/vec.hpp"

/// Convex shapes of rigid walls, in closed form: how far a point is, where a way leads in.
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
    Vec3 corner = Vec3::Zero();                          ///< [m]
    Mat3 axes = Mat3::Identity();                        ///< columns: two edges, normal
    double low[2] = {-INF, -INF}, high[2] = {INF, INF};  ///< along the edges             [m]
};

struct Ball {
    Vec3 centre = Vec3::Zero();  ///< [m]
    double radius = NaN;         ///< [m]
};

/// A round cylinder with flat ends.
struct Rod {
    Vec3 base = Vec3::Zero();  ///< [m]
    Vec3 axis = Vec3::UnitZ();
    double radius = NaN;            ///< [m]
    double low = -INF, high = INF;  ///< along the axis from the base                         [m]
};

/// A brick.
struct Brick {
    Vec3 corner = Vec3::Zero();                                   ///< [m]
    Mat3 axes = Mat3::Identity();                                 ///< columns
    Vec3 low = Vec3::Constant(-INF), high = Vec3::Constant(INF);  ///< along the axes         [m]
};

using WallShape = std::variant<HalfSpace, Plate, Ball, Rod, Brick>;

/// Of a point: its distance from the shape, below 0 inside, and the outward normal there. Of a
/// plate: the height above its plane.
struct Nearby {
    double gap = INF;  ///< [m]
    Vec3 normal = Vec3::Zero();
};
[[nodiscard]] Nearby nearest(const WallShape& shape, const Vec3& at);

/// Where a straight way leads in: the share of the way, and the outward normal there.
struct Entry {
    double share = 0.0;  ///< 0 to 1  [-]
    Vec3 normal = Vec3::Zero();
};
/// The first entry of the way from a place outside to another; none where it stays outside.
/// A plate is entered from its front only.
[[nodiscard]] std::optional<Entry> entry(const WallShape& shape, const Vec3& from, const Vec3& to);

/// Does the place lie above or below the rectangle?
[[nodiscard]] bool covers(const Plate& plate, const Vec3& at);

/// Normal of a wall that is plane; 0 of one that is not.
[[nodiscard]] Vec3 plane_normal(const WallShape& shape);

}  // namespace corpuscle::contact
