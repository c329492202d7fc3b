// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

#include "io/deck/keyword_reader.hpp"
#include "io/deck/parameters.hpp"

namespace corpuscle::io {

/// A number that tells a deck's text from others', with all that it includes: FNV-1a, 64 bits, over
/// the files in the order in which they are read. A file that cannot be read counts as none.
[[nodiscard]] std::uint64_t deck_fingerprint(const std::filesystem::path& deck);

/// A number that tells what a deck says of its scene from what others say: likewise, over keywords
/// and cards without comments, and the parameters that they name. When the run ends and how often
/// what is written are no part of the scene.
[[nodiscard]] std::uint64_t scene_fingerprint(const DeckText& text, Parameters& parameters);

}  // namespace corpuscle::io
