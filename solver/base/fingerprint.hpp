// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>

namespace corpuscle {

/// Tells blocks of bytes apart: FNV-1a, 64 bits [Fowler, Noll, Vo 1991].
[[nodiscard]] inline std::uint64_t fingerprint(std::span<const char> bytes) {
    std::uint64_t hash = 0xcbf29ce484222325U;
    for (const char byte : bytes) {
        hash ^= static_cast<unsigned char>(byte);
        hash *= 0x100000001b3U;
    }
    return hash;
}

}  // namespace corpuscle
