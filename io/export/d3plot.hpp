// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "io/results/hdf5.hpp"

namespace corpuscle::io {

/// Takes a file of a d3plot database: "d3plot", "d3plot01", ..., "d3plot100", ... and its bytes.
using D3plotFile = std::function<void(const std::string& name, const std::string& bytes)>;

/// The results' shells (of fabric and rigid bodies) as a d3plot database, 4-byte words: geometry,
/// then a file a frame. io/FORMAT.md says what a state holds.
/// @param has_particles  false: without the particles, for readers that do not know them
void write_d3plot(const Hdf5Reader& results, const D3plotFile& write, bool has_particles = true);

/// Is this the beginning of a "d3plot" that write_d3plot() wrote? It has no time of the run and no
/// version of a program, which LS-DYNA's has.
[[nodiscard]] bool is_own_d3plot(std::string_view beginning);

}  // namespace corpuscle::io
