// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>

#include "solver/base/error.hpp"

namespace corpuscle::io {
namespace {

/// Is the open file still the one of that name? Who held it before may have removed it meanwhile.
bool is_named(int handle, const std::filesystem::path& file) {
    struct stat open_one {};
    struct stat named {};
    return fstat(handle, &open_one) == 0 && stat(file.c_str(), &named) == 0 &&
           open_one.st_ino == named.st_ino && open_one.st_dev == named.st_dev;
}

/// Who holds it, as it wrote there: its process's number.
std::string holder(int handle) {
    std::array<char, 32> text{};
    const ssize_t size = pread(handle, text.data(), text.size() - 1, 0);
    return size > 0 ? fmt::format(" (process {})", text.data()) : std::string();
}

constexpr const char* EXPECTED_OF_OWN = "a folder of its own for each: -o DIR";
constexpr const char* EXPECTED_OF_SHARED = "the end of that run first, or another folder: -o DIR";

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, Kind kind)
    : file_(folder / "lock"), kind_(kind) {
    std::error_code why;
    std::filesystem::create_directories(folder, why);
    if (why)
        throw SystemError(
            fmt::format("cannot make the results folder {}: {}", folder.string(), why.message()));
    for (;;) {
        handle_ = open(file_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        if (handle_ < 0)
            throw SystemError(
                fmt::format("cannot write {}: {}", file_.string(), std::strerror(errno)));
        if (flock(handle_, (kind == Kind::OWN ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) {
            if (errno != EWOULDBLOCK) return;  // no locks on this disk
            const std::string who = holder(handle_);
            close(handle_);
            throw InputError(fmt::format("{} is in use by another run{}, expected {}",
                                         folder.string(), who,
                                         kind == Kind::OWN ? EXPECTED_OF_OWN : EXPECTED_OF_SHARED));
        }
        if (is_named(handle_, file_)) break;
        close(handle_);
    }
    const std::string me = std::to_string(getpid());
    // whether others can read who it is makes no difference to the lock
    static_cast<void>(!pwrite(handle_, me.data(), me.size(), 0));
    static_cast<void>(!ftruncate(handle_, static_cast<off_t>(me.size())));
}

/// Removed while it is still held, so that nobody is in between; a shared one is others' too.
FolderLock::~FolderLock() {
    std::error_code ignored;
    if (kind_ == Kind::OWN) std::filesystem::remove(file_, ignored);
    close(handle_);
}

}  // namespace corpuscle::io
