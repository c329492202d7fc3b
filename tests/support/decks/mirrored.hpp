// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace corpuscle::support {

/// Deck of random_scene() with each quad in two triangles.
[[nodiscard]] std::string triangulated(const std::string& deck);

/// Deck of triangles, mirrored at x = 0: warp and weft stay on their edges, normals on their side.
/// Nodes get other ids; nodes and shells stand in another order.
[[nodiscard]] std::string mirrored(const std::string& deck, unsigned seed);

}  // namespace corpuscle::support
