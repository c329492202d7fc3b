// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/support/random/random_scene.hpp"

namespace corpuscle::support {

/// A scene whose bag is folded.
struct FoldedScene : RandomScene {
    std::string recipe;                ///< that it was folded by
    std::vector<std::string> refused;  ///< why recipes drawn before that one cannot be folded
    bool is_free;                      ///< nothing holds the bag
};

/// A bag of some hundred shells, folded by a random recipe, and the first 2 to 6 ms of its way out;
/// a second or two of computing. The cloth round the inflator is held, or a rigid part that nothing
/// holds (then momentum is constant from 0.4 of the time on, as in free_scene()). By chance: vents,
/// a porous front, a tether, heat to the walls, TSW, gases and nozzles as in random_scene(), on the
/// held cloth or before it; a floor, a wall, a driven wall or a rigid body in the way, weight, and
/// DT2MS, always where folds are oblique, for slivers.
/// @throws std::runtime_error  where twenty recipes in turn are refused
[[nodiscard]] FoldedScene folded_scene(unsigned seed);

}  // namespace corpuscle::support
