// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/geometry/distance.hpp"

namespace corpuscle::contact {

/// A step without impact, from time_of_impact().
inline constexpr double NO_IMPACT = 2.0;

/// When two places that move from x to x + displacement come nearer than a tenth of their distance
/// now, or of `thickness` if that is less: part of the step in [0, 1], or NO_IMPACT.
///
/// Conservative: never later than the truth, so a pair that has no impact has not passed through.
/// Places that touch at the start (distance 0) are beyond help: NO_IMPACT.
///
/// Method: advancing by no more than the distance that is left over the greatest relative
/// displacement [Li et al. 2021, additive continuous collision detection], seen from the mean
/// displacement of all four nodes. cost: one distance for each advance; one in all for most pairs
[[nodiscard]] double time_of_impact(const Pair& pair, const Corners& x, Corners displacement,
                                    double thickness);

}  // namespace corpuscle::contact
