// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/collisions/cell_sample.hpp"
#include "gas/collisions/collide.hpp"

namespace corpuscle::gas {

/// Uniform on SO(3), from a uniform unit quaternion [Shoemake 1992].
Mat3 random_rotation(Random& draw);

/// A group whose energy, less that of its motion in common, belongs to no temperature (it has debts
/// to pay): nothing changes but for its heat, which goes to the internal energy, so that angular
/// momentum stays, or is refused. False.
bool leave_unrelaxed(CellSample& sample);

/// LIN for a group too small, or too flat, for a velocity gradient: c is turned round at random,
/// and angular momentum is kept by the rotation that is lent to it for that and taken out again. Of
/// two particles only the velocity along their line can turn round.
bool collide_few(const CollisionStep& step, CellSample& sample, Random& draw);

}  // namespace corpuscle::gas
