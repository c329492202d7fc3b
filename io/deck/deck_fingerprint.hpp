// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace corpuscle::io {

/// A number that tells a deck's text from others', with all that it includes: FNV-1a, 64 bits, over
/// the files in the order in which they are read. A file that cannot be read counts as none.
[[nodiscard]] std::uint64_t deck_fingerprint(const std::filesystem::path& deck);

}  // namespace corpuscle::io
