// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace corpuscle::gas {

/// A pressure above `p_out` whose excess is beyond chance: d (1 - (3 e / d)²) for d, none below
/// 3 e.                                                                                   [Pa]
inline double beyond_chance(double p, double p_out, double error) {
    const double d = p - p_out, e = 3.0 * error;
    return d > e ? p_out + d - e * e / d : std::min(p, p_out);
}

}  // namespace corpuscle::gas
