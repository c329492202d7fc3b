// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/atomic_file.hpp"

#include <fmt/format.h>

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
    const std::filesystem::path next = next_version(file);
    const auto fail = [&] {
        throw SystemError(fmt::format("cannot write {}: {}", file.string(), std::strerror(errno)));
    };
    std::FILE* out = std::fopen(next.c_str(), "wb");
    if (out == nullptr) fail();
    const bool written = std::fwrite(text.data(), 1, text.size(), out) == text.size();
    const bool closed = std::fclose(out) == 0;
    if (!written || !closed) fail();
    take_its_name(file);
}

}  // namespace corpuscle::io
