// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "solver/scene/scene_state.hpp"

namespace corpuscle {

/// Tells bags whose holes contact closes which nodes touch fabric or walls, and how hard.
class TouchingNodes {
public:
    /// @param span  of the kick that has just been made                               [s]
    void tell_bags(SceneState& scene, double span);

private:
    void find_push(const SceneState& scene, double span);

    std::vector<std::uint8_t> touching_;  ///< N: nodes in contact
    std::vector<std::uint8_t> held_;      ///< N: SceneState::held_nodes()
    Points push_;                         ///< N × 3: contact and obstacles, if a bag asks  [N]
};

}  // namespace corpuscle
