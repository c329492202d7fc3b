// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

namespace corpuscle::test {

/// Particles that lie outside of the closed surface of their bag, and the particles looked at: all
/// frames together.
struct Outside {
    std::size_t particles = 0, seen = 0;
};

/// By the winding number of the surface that the bag's gas is held by, lids of holes included,
/// about each particle. One within rounding of a wall counts as inside.
/// @param deck     of the run
/// @param results  results.h5
[[nodiscard]] Outside particles_outside(const std::filesystem::path& deck,
                                        const std::filesystem::path& results);

}  // namespace corpuscle::test
