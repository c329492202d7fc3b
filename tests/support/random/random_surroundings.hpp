// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "tests/support/draw.hpp"
#include "tests/support/random/random_plan.hpp"

namespace corpuscle::support {

/// Cards of what stands in the way of cloth that moves, drawn apart: a plane above the bag or
/// beside it, or a rigid body that flies against its top; some of the cloth's weight, and its speed
/// where nothing holds it. Says so in `words`.
[[nodiscard]] std::string surroundings(const Plan& plan, unsigned seed, std::string& words);

/// The same of a folded bag that lies in a box: a floor below it; a rigid body, a plane, or a plane
/// that is driven, above it; some of the cloth's weight.
[[nodiscard]] std::string surroundings_of_pack(const Plan& plan, const Eigen::AlignedBox3d& pack,
                                               Draw& draw, std::string& words);

}  // namespace corpuscle::support
