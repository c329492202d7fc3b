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

/// Refuses a folder with files of the names that a run writes or removes, where nothing there is of
/// this program, or where an export or a text file is another's: those results stay as they are.
/// @throws InputError  that names them
void expect_own_results(const std::filesystem::path& folder);

/// Exports and responses of an earlier run would pass for this one's: removed, and named on the
/// standard output. Of a test's folder (NAME/NAME.mme) what this program wrote; the rest stays. After
/// expect_own_results().
void remove_old_exports(const std::filesystem::path& folder);

}  // namespace corpuscle::tools
