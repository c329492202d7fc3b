// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace corpuscle::io::keywords {

/// TC and RC of *NODE, CON1 and CON2 of *MAT_RIGID: none, x, y, z, xy, yz, zx, xyz -> bits 0 x, 1
/// y, 2 z.
inline constexpr std::array<unsigned, 8> HELD = {0U, 1U, 2U, 4U, 3U, 6U, 5U, 7U};

}  // namespace corpuscle::io::keywords
