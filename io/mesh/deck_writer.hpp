// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/mesh/mesh_file.hpp"

namespace corpuscle::io {

/// Writes a mesh as a keyword deck: *NODE, *ELEMENT_SHELL and *PART in standard columns, all
/// numbered from 1. Part P asks for section P and material P, which are left for the user to add.
/// @throws SystemError if the file cannot be written, InputError if a number needs more than 8
/// columns
void write_deck(const std::filesystem::path& file, const ImportedMesh& mesh,
                std::string_view title);

/// `value` in 16 columns with all the digits that fit.
[[nodiscard]] std::string in_16_columns(double value);

}  // namespace corpuscle::io
