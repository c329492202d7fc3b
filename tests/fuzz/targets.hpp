// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

/// What damaged files are given to.
namespace corpuscle::fuzz {

/// What may come of a file; everything else is a failure.
enum class Outcome : char {
    TAKEN = 't',    ///< read, and for a deck run for some steps
    REFUSED = 'r',  ///< bad input, each fault told: status 2
    STOPPED = 's',  ///< the physics broke: status 3
    DAMAGED = 'd',  ///< cannot be read: status 1
};

struct Target {
    std::string name;
    std::string file;                ///< as which a case is written
    bool is_text;                    ///< else bytes
    std::vector<std::string> seeds;  ///< small files that are good
    /// Reads the file. What it throws but InputError, PhysicsError and SystemError is a failure.
    std::function<void(const std::filesystem::path&)> read;
};

/// @param models  folder of the ready decks, @param decks  of the small ones,
/// @param work    where seeds are made
[[nodiscard]] std::vector<Target> all_targets(const std::filesystem::path& models,
                                              const std::filesystem::path& decks,
                                              const std::filesystem::path& work);

}  // namespace corpuscle::fuzz
