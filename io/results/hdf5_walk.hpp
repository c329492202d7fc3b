// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace corpuscle::io {

/// Texts lie in HDF5's global heap, which has no checksum: where its sizes are damaged, libhdf5
/// reads or frees memory that is not its own. A process of its own opens all that the file names
/// and reads all its texts; what is an error there is met, and told, by who reads.
/// @throws SystemError if that process crashed or took too much
void expect_survivable(const std::filesystem::path& file);

}  // namespace corpuscle::io
