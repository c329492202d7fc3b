// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/folder_lock.hpp"

#include <catch2/catch.hpp>

#include <fstream>

#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::FolderLock;

TEST_CASE("a folder in use is refused, and free again afterwards", "[io]") {
    const scene::Folder folder("lock");
    {
        const FolderLock first(folder.path);
        CHECK_THROWS_WITH(
            FolderLock(folder.path),
            Catch::Contains("is in use by another run (process " + std::to_string(getpid()) + ")"));
        CHECK_THROWS_AS(FolderLock(folder.path), InputError);
        CHECK(std::filesystem::exists(folder.path / "lock"));
    }
    CHECK_FALSE(std::filesystem::exists(folder.path / "lock"));
    const FolderLock second(folder.path);
}

TEST_CASE("a shared folder is free to others that share it, and to nobody as its own", "[io]") {
    const scene::Folder folder("shared_lock");
    const auto shared = FolderLock::Kind::SHARED;
    {
        const FolderLock first(folder.path, shared);
        { const FolderLock second(folder.path, shared); }
        CHECK(std::filesystem::exists(folder.path / "lock"));  // the first one's still
        CHECK_THROWS_WITH(FolderLock(folder.path), Catch::Contains("is in use by another run"));
        const FolderLock third(folder.path, shared);
    }
    const FolderLock own(folder.path);
    CHECK_THROWS_WITH(
        FolderLock(folder.path, shared),
        Catch::Contains("is in use by another run (process " + std::to_string(getpid()) +
                        "), expected the end of that run first"));
}

TEST_CASE("a lock's file that a killed run has left holds nobody up", "[io]") {
    const scene::Folder folder("left_lock");
    std::filesystem::create_directories(folder.path);
    std::ofstream(folder.path / "lock") << "123456789012345";
    const FolderLock lock(folder.path);
    CHECK_THROWS_WITH(FolderLock(folder.path), Catch::Contains(std::to_string(getpid()) + ")"));
}

TEST_CASE("a folder to lock that cannot be made is named with the reason", "[io]") {
    const scene::Folder folder("no_lock");
    std::ofstream(folder.path) << "a file";
    CHECK_THROWS_AS(FolderLock(folder.path / "deeper"), SystemError);
}
