// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::oracle {

/// How often a closed surface winds round a point: 1 inside, 0 outside, sign by its orientation.
///
/// The sum of its triangles' solid angles over 4 pi [van Oosterom & Strackee 1983]. Plain and slow.
double winding_number(const Vec3& point, const std::vector<std::array<Vec3, 3>>& triangles);

/// Whether the point is inside, give or take `slack` along any axis.
bool is_inside(const Vec3& point, const std::vector<std::array<Vec3, 3>>& triangles, double slack);

}  // namespace corpuscle::oracle
