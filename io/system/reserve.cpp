// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/reserve.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <system_error>

#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// A version may grow to this much before the next one is counted: by rows that came meanwhile.
constexpr std::uint64_t SPARE = std::uint64_t{1} << 16;

}  // namespace

void Reserve::hold_for(std::uint64_t version) {
    const std::uint64_t needed = version + version / 4 + SPARE;
    if (needed <= size_) return;
    const std::uint64_t wanted = needed + needed / 2;  // so that most versions need no more
    const int file = open(file_.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
    if (file < 0) return;
    if (posix_fallocate(file, 0, static_cast<off_t>(wanted)) == 0)
        size_ = wanted;
    else if (ftruncate(file, static_cast<off_t>(size_)) != 0)
        size_ = 0;  // whatever it holds now, it is not counted on
    close(file);
}

void expect_room(const std::filesystem::path& folder, std::uint64_t size) {
    const std::filesystem::path probe = folder / "room";
    const int file = open(probe.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0644);
    // the call of the system itself: C's would write to each block where a disk cannot do this
    int why = file < 0 || fallocate(file, 0, 0, static_cast<off_t>(size)) != 0 ? errno : 0;
    if (file >= 0) close(file);
    std::error_code ignored;
    std::filesystem::remove(probe, ignored);
    if (why == EOPNOTSUPP)
        why = std::filesystem::space(folder, ignored).available < size ? ENOSPC : 0;
    if (why != 0)
        throw SystemError(fmt::format("no room in {} for a file of {:.3g} MB: {}", folder.string(),
                                      1e-6 * static_cast<double>(size), std::strerror(why)));
}

void Reserve::release() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
    size_ = 0;
}

}  // namespace corpuscle::io
