// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <cstdint>
#include <limits>
#include <vector>

/// Airbag deployment by the corpuscular method: a scene as data (Model), in motion (Simulation), and
/// what all rooms stand on. Numbers are in one consistent unit system; units named are those of SI.
namespace corpuscle {

using Vec3 = Eigen::Vector3d;  ///< point, velocity, force: 3 doubles, no padding
using Mat3 = Eigen::Matrix3d;  ///< 3 x 3, column by column: rotations, inertia
using Index = std::int32_t;    ///< row in an array; deck ids are never used as rows

inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();  ///< "no honest default"
inline constexpr double INF = std::numeric_limits<double>::infinity();   ///< "without end"

/// N points or vectors, one row each in results files (N × 3).
using Points = std::vector<Vec3>;

}  // namespace corpuscle
