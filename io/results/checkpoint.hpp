// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace corpuscle::io {

/// The state of a run at one instant, in FOLDER/checkpoint: with the deck it was made from, all
/// that a restart needs to end in the same bits as the run that was never broken off.
struct Checkpoint {
    std::uint64_t scene = 0;  ///< fingerprint of the scene
    double t = 0.0;           ///< where the run is  [s]
    std::int64_t step = 0;    ///< made so far
    std::vector<char> state;  ///< of the simulation and its outputs (solver/base/archive.hpp)
};

/// Takes the place of the checkpoint before it in one stroke.
/// @throws SystemError  where it cannot be written; the one before it is there then
void write_checkpoint(const std::filesystem::path& folder, const Checkpoint& checkpoint);

/// The checkpoint of a folder, or none. @throws SystemError for one that is damaged or of another
/// version of the program
[[nodiscard]] std::optional<Checkpoint> read_checkpoint(const std::filesystem::path& folder);

/// FNV-1a [Fowler, Noll, Vo 1991] by words of eight bytes, each turned by 29 bits:
///
///     h' = rotl(h ^ w, 29) · P
///
/// The last word has the bytes that are left, and their number. Bijective in each word: a change
/// within one is always seen.
[[nodiscard]] std::uint64_t checkpoint_checksum(std::span<const char> bytes);

/// Should there be one; without it a restart begins at the start.
void remove_checkpoint(const std::filesystem::path& folder);

}  // namespace corpuscle::io
