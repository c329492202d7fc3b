// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/results/hdf5_walk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <system_error>

#include "io/results/hdf5.hpp"
#include "io/system/confined.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

constexpr int DEEPEST = 16;  ///< groups in groups; results have five

/// A million datasets take a minute; each has some hundred bytes at least. [s]
int seconds_for(const std::filesystem::path& file) {
    constexpr std::uintmax_t LEAST = 5, MOST = 60, BYTES_A_SECOND = std::uintmax_t{1} << 20;
    std::error_code unknown;
    const std::uintmax_t size = std::filesystem::file_size(file, unknown);
    return static_cast<int>(unknown ? MOST : std::min(MOST, LEAST + size / BYTES_A_SECOND));
}

/// What is an error here is left for the reader to meet, and to tell.
template <class Look>
void attempt(Look&& look) {
    try {
        look();
    } catch (const SystemError&) {
    }
}

/// An attribute that is a number is an error too.
void read_texts(const Hdf5Reader& file, const std::string& path) {
    attempt([&] {
        for (const std::string& name : file.attributes(path))
            attempt([&] { static_cast<void>(file.text(path, name)); });
    });
}

void walk(const Hdf5Reader& file, const std::string& group, int depth) {
    read_texts(file, group);
    for (const std::string& name : file.names(group)) {
        const std::string path = (group == "/" ? "" : group) + "/" + name;
        attempt([&] {
            if (!file.is_group(path))
                read_texts(file, path);
            else if (depth < DEEPEST)
                walk(file, path, depth + 1);
        });
    }
}

}  // namespace

void expect_survivable(const std::filesystem::path& file) {
    const Confined walked = confined(
        [&] {
            attempt([&] { walk(Hdf5Reader(file, Hdf5Reader::Origin::OWN), "/", 1); });
            return std::vector<char>{};
        },
        {.seconds = seconds_for(file), .is_mute = true});
    if (!walked.bytes)
        throw SystemError(
            fmt::format("cannot read {}: it is damaged: {}", file.string(), walked.failure));
}

}  // namespace corpuscle::io
