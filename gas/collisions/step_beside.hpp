// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace corpuscle::gas {

/// Step of a gas that wants g by its collisions, beside cloth that wants f: cloth is not held up for a
/// little blur, and what wants much more has its own way,
///
///     f                      f <= q g,      q = 3/2
///     max(g, (q g)² / f)     else                                                                 [s]
///
/// so from g to q g, continuous in both. Particles cross 3/16 of a cell in q g: errors of Sod's tube
/// are 7 % above those at an eighth.
/// @param gas    INF: none
/// @param cloth  INF: none
[[nodiscard]] inline double step_beside(double gas, double cloth) {
    const double most = 1.5 * gas;
    return cloth <= most ? cloth : std::max(gas, most / cloth * most);
}

}  // namespace corpuscle::gas
