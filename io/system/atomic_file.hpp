// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <span>
#include <string_view>

/// A file that others may read at any instant is never changed in place: its next version is
/// written beside it and then takes its name, which the system does in one stroke. A symbolic link
/// stays one: `file` is then what it leads to.
namespace corpuscle::io {

/// Where the next version of `file` is written. @throws SystemError  of links that lead in a circle
[[nodiscard]] std::filesystem::path next_version(const std::filesystem::path& file);

/// next_version(file) becomes `file`. @throws SystemError
void take_its_name(const std::filesystem::path& file);

/// `file` holds `text` from now on; a pipe or a device gets it. @throws SystemError; a regular file
/// is then as it was
void replace_text(const std::filesystem::path& file, std::string_view text);
/// Likewise these parts, one behind the other.
void replace_text(const std::filesystem::path& file, std::span<const std::string_view> parts);

}  // namespace corpuscle::io
