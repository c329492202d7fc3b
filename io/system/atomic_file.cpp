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
namespace {

namespace fs = std::filesystem;

/// What a symbolic link leads to in the end, be it there or not; of all else itself.
fs::path target_of(const fs::path& file) {
    constexpr int MOST_LINKS = 40;  // as the system has it
    fs::path target = file;
    std::error_code no_link;
    for (int links = 0; fs::is_symlink(target, no_link); ++links) {
        if (links == MOST_LINKS)
            throw SystemError(
                fmt::format("cannot write {}: {}", file.string(), std::strerror(ELOOP)));
        target = target.parent_path() / fs::read_symlink(target, no_link);
    }
    return target;
}

/// Why the texts are not in a file, the first reason; 0: they are.
int put_texts(const fs::path& file, std::span<const std::string_view> parts) {
    std::FILE* out = std::fopen(file.c_str(), "wb");
    if (out == nullptr) return errno;
    const bool is_written = std::all_of(parts.begin(), parts.end(), [&](std::string_view part) {
        return std::fwrite(part.data(), 1, part.size(), out) == part.size();
    });
    const int while_writing = errno;
    const bool is_closed = std::fclose(out) == 0;
    if (is_written && is_closed) return 0;
    const int why = is_written ? errno : while_writing;
    return why != 0 ? why : EIO;
}

/// Is there something that is not replaced but written to: a pipe, a device?
bool takes_text_itself(const fs::path& file) {
    std::error_code unknown;
    const fs::file_status status = fs::status(file, unknown);
    return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

std::filesystem::path next_version(const std::filesystem::path& file) {
    std::filesystem::path next = target_of(file);
    next += ".next";
    return next;
}

void take_its_name(const std::filesystem::path& file) {
    std::error_code why;
    std::filesystem::rename(next_version(file), target_of(file), why);
    if (why) throw SystemError(fmt::format("cannot write {}: {}", file.string(), why.message()));
}

void replace_text(const std::filesystem::path& file, std::string_view text) {
    replace_text(file, std::span(&text, 1));
}

void replace_text(const std::filesystem::path& file, std::span<const std::string_view> parts) {
    const bool is_replaced = !takes_text_itself(file);
    const fs::path to = is_replaced ? next_version(file) : file;
    const int why = put_texts(to, parts);
    if (why == 0) {
        if (is_replaced) take_its_name(file);
        return;
    }
    std::error_code ignored;
    if (is_replaced) fs::remove(to, ignored);
    throw SystemError(fmt::format("cannot write {}: {}", file.string(), std::strerror(why)));
}

}  // namespace corpuscle::io
