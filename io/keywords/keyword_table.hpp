// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace corpuscle::io {

/// The table of all keywords and their fields: acted on, warned of, of no matter, refused. It is
/// worked out by giving cards to the readers and looking what they do with the fields.
/// @param folder  for decks that are written on the way
std::string keyword_table(const std::filesystem::path& folder);

}  // namespace corpuscle::io
