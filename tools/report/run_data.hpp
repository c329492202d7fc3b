// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace corpuscle::report {

/// What a page is given of a run: JSON that says what is where, and bytes.
///
///     triangles   uint32  3 a triangle: rows of nodes; shell of each triangle
///     positions   uint16  3 a node and frame, in the box; changes since the frame before
///     fields      uint8   1 a shell and frame, in the field's range
///     particles   uint16  3 a particle, then uint8 of species and of speed, frame by frame
///     histories   float32 all rows of one column, column by column
struct RunData {
    std::string json;
    std::string bytes;
};

/// More frames than this, or particles, are thinned out evenly, and the page says so.
inline constexpr std::size_t MOST_FRAMES = 60, MOST_PARTICLES = 20000;

/// @throws SystemError if the folder holds no results
[[nodiscard]] RunData run_data(const std::filesystem::path& folder);

}  // namespace corpuscle::report
