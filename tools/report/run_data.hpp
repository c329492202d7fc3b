// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace corpuscle::report {

/// What a page is given of a run: JSON that says what is where, and bytes.
///
///     triangles   uint32  3 a triangle: rows of nodes; shell of each triangle
///     histories   float32 all rows of one column, column by column
///
/// and of each frame bytes of its own, so that the page opens when it has the first:
///
///     positions   uint16  3 a node, in the box; changes since the frame before
///     fields      uint8   1 a shell, in the field's range
///     particles   uint16  3 a particle, then uint8 of species and of speed
struct RunData {
    std::string json;
    std::string bytes;
    std::vector<std::string> frames;
};

/// More frames than this, or particles, are thinned out evenly, and the page says so.
inline constexpr std::size_t MOST_FRAMES = 60, MOST_PARTICLES = 20000;

/// @throws SystemError if the folder holds no results
[[nodiscard]] RunData run_data(const std::filesystem::path& folder);

}  // namespace corpuscle::report
