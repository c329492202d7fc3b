// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/records.hpp"

/// What stands in results.h5 and its parts (io/FORMAT.md).
namespace corpuscle::io {

/// The root's attributes.
void fill_root(Hdf5Writer& file, const RunInfo& info, const std::string& termination);
/// @param topology  for XDMF: each shell as its type and rows
void fill_mesh(Hdf5Writer& file, const RecordLayout& layout, const std::string& units,
               std::span<const std::int32_t> topology);
void fill_frame(Hdf5Writer& file, const Frame& frame, const std::string& units);
/// Groups of the frames in the order of time: "/frames/00000/", "/frames/00001/", ...
[[nodiscard]] std::vector<std::string> frame_groups(const Hdf5Reader& results);
/// @throws PhysicsError that names the first number of a frame that is not finite
void expect_finite(const Frame& frame, const RecordLayout& layout);

}  // namespace corpuscle::io
