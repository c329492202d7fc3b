// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>

namespace corpuscle::verify {

struct FrameCrossings {
    std::size_t frames = 0;
    std::size_t crossings = 0;  ///< pairs of triangles, all frames together
    std::size_t worst = 0;      ///< in one frame
};

/// Counts exactly (contact/broad_phase/intersections.hpp) where shells cross in the frames of a results.h5.
[[nodiscard]] FrameCrossings frame_crossings(const std::filesystem::path& results);

}  // namespace corpuscle::verify
