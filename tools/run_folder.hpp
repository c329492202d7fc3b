// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "io/results/results_file.hpp"
#include "solver/model.hpp"

namespace corpuscle::tools {

/// What results say of the run that they are of.
/// @param scene  fingerprint of the scene
[[nodiscard]] io::RunInfo run_info(const Model& model, std::string_view version, std::uint64_t seed,
                                   std::uint64_t scene);

/// Exports and responses of an earlier run would pass for this one's: removed, and named on the
/// standard output.
void remove_old_exports(const std::filesystem::path& folder);

}  // namespace corpuscle::tools
