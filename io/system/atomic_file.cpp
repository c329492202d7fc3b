// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "solver/base/error.hpp"

namespace corpuscle::io {

std::filesystem::path next_version(const std::filesystem::path& file) {
    std::filesystem::path next = file;
    next += ".next";
    return next;
}

void take_its_name(const std::filesystem::path& file) {
    std::error_code why;
    std::filesystem::rename(next_version(file), file, why);
    if (why) throw SystemError(fmt::format("cannot write {}: {}", file.string(), why.message()));
}

void replace_text(const std::filesystem::path& file, std::string_view text) {
    replace_text(file, std::span(&text, 1));
}

void replace_text(const std::filesystem::path& file, std::span<const std::string_view> parts) {
    const std::filesystem::path next = next_version(file);
    const auto fail = [&] {
        throw SystemError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
    };
    std::FILE* out = std::fopen(next.c_str(), "wb");
    if (out == nullptr) fail();
    const bool written = std::all_of(parts.begin(), parts.end(), [&](std::string_view part) {
        return std::fwrite(part.data(), 1, part.size(), out) == part.size();
    });
    const bool closed = std::fclose(out) == 0;
    if (!written || !closed) fail();
    take_its_name(file);
}

}  // namespace corpuscle::io
