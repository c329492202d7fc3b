// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace corpuscle::io {

/// A results folder that is this run's own until the end of the scope: the file FOLDER/lock, held
/// by the system (flock), which lets go of it however the process ends. Where a disk has no locks
/// to give, folders are free to all.
class FolderLock {
public:
    enum class Kind { OWN, SHARED };

    /// Makes the folder where there is none.
    /// @param kind  SHARED: beside others that share it, not beside one whose own it is
    /// @throws InputError if another process holds it, SystemError if it cannot be made
    explicit FolderLock(const std::filesystem::path& folder, Kind kind = Kind::OWN);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

private:
    std::filesystem::path file_;
    Kind kind_;
    int handle_ = -1;
};

}  // namespace corpuscle::io
