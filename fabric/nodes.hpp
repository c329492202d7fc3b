// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// Nodes of the whole scene. Leapfrog: x live at t, v at t - dt/2 before the kick, t + dt/2 after it.
struct Nodes {
    Points x;                   ///< position at t               N × 3    [m]
    Points x_1;                 ///< position at t + dt          N × 3    [m]
    Points v;                   ///< velocity                    N × 3    [m/s]
    Points f;                   ///< force at t                  N × 3    [N]
    std::vector<double> mass;   ///< lumped                      N        [kg]

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

}  // namespace corpuscle::fabric
