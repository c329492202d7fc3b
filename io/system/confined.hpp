// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace corpuscle::io {

/// What a confined reader may take.
struct Limits {
    int seconds = 5;  ///< of a processor's time; WAIT times that by the wall's clock       [s]
    std::uint64_t memory = std::uint64_t{4} << 30;  ///< beyond what the program has now [byte]
    bool is_mute = false;  ///< standard error says nothing: that of a library that crashes

    static constexpr int WAIT = 10;
};

/// What came of it: the bytes that it handed over, or why there are none.
struct Confined {
    std::optional<std::vector<char>> bytes;
    std::string failure;  ///< "reading took more than 5 s, given up" ...; "" if none
};

/// Reads in a process of its own, so that nothing that happens to it happens to this
/// one: for code of others on files of unknown origin. The reader may throw: what it threw says why.
/// @throws SystemError if the system has no process to give
[[nodiscard]] Confined confined(const std::function<std::vector<char>()>& reader,
                                const Limits& limits = {});

}  // namespace corpuscle::io
