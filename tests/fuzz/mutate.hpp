// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "solver/base/random.hpp"

/// Files as they come to be damaged: by hands that edit them, and on disks. What is drawn decides
/// alone, so that a case is known by its number.
namespace corpuscle::fuzz {

/// Text of cards or of tables: fields swapped, emptied, or replaced by numbers that nobody expects;
/// lines doubled, dropped or moved; pieces of another text put in; some bytes at random.
/// @param other  of the same kind
[[nodiscard]] std::string damaged_text(std::string text, const std::string& other, Random& draw);

/// Bytes: bits turned over, blocks overwritten or moved, numbers of 4 and 8 bytes made extreme, the
/// end cut off.
[[nodiscard]] std::string damaged_bytes(std::string bytes, Random& draw);

}  // namespace corpuscle::fuzz
