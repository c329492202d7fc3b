// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/system/atomic_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sys/resource.h>
#include <array>
#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <sstream>

#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;

namespace {

std::string content(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file, std::ios::binary).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("a text takes the place of another, and of a link its target", "[io]") {
    const scene::Folder folder("replace");
    const auto &here = folder.path, file = here / "far" / "text";
    std::filesystem::create_directories(here / "far");
    io::replace_text(file, "one");
    CHECK(content(file) == "one");
    std::filesystem::create_symlink("far/text", here / "link");
    std::filesystem::create_symlink(here / "link", here / "far" / "link");
    io::replace_text(here / "far" / "link", "two");
    CHECK(content(file) == "two");
    CHECK(std::filesystem::is_symlink(here / "link"));
    CHECK(std::filesystem::is_symlink(here / "far" / "link"));
    CHECK_FALSE(std::filesystem::exists(io::next_version(file)));
    SECTION("that is not there yet") {
        std::filesystem::remove(file);
        io::replace_text(here / "link", "three");
        CHECK(content(file) == "three");
        CHECK(std::filesystem::is_symlink(here / "link"));
    }
    SECTION("in a circle there is none") {
        std::filesystem::create_symlink("ring", here / "ring");
        CHECK_THROWS_AS(io::replace_text(here / "ring", "four"), SystemError);
        CHECK(std::filesystem::is_symlink(here / "ring"));
    }
}

TEST_CASE("a pipe gets the text and stays a pipe", "[io]") {
    const scene::Folder folder("pipe");
    std::filesystem::create_directories(folder.path);
    const auto pipe = folder.path / "pipe";
    REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK);
    io::replace_text(pipe, "text");
    std::array<char, 16> got{};
    CHECK(read(reader, got.data(), got.size()) == 4);
    CHECK(std::string(got.data()) == "text");
    close(reader);
    CHECK(std::filesystem::is_fifo(pipe));
}

TEST_CASE("a folder in the way of a text is told with its reason", "[io]") {
    const scene::Folder folder("in_the_way");
    std::filesystem::create_directories(folder.path);
    CHECK_THROWS_WITH(io::replace_text(folder.path, "text"), Catch::Contains("Is a directory"));
}

TEST_CASE("of a text that the disk does not take nothing stays, and the reason is told", "[io]") {
    const scene::Folder folder("full_disk");
    std::filesystem::create_directories(folder.path);
    const auto file = folder.path / "text";
    io::replace_text(file, "one");
    rlimit all{};
    REQUIRE(getrlimit(RLIMIT_FSIZE, &all) == 0);
    const rlimit few{1000, all.rlim_max};
    const auto before = std::signal(SIGXFSZ, SIG_IGN);
    REQUIRE(setrlimit(RLIMIT_FSIZE, &few) == 0);
    std::string said;
    try {
        io::replace_text(file, std::string(100000, 'x'));
    } catch (const SystemError& error) {
        said = error.what();
    }
    setrlimit(RLIMIT_FSIZE, &all);
    std::signal(SIGXFSZ, before);
    CHECK_THAT(said, Catch::Contains("text: File too large"));
    CHECK(content(file) == "one");
    CHECK_FALSE(std::filesystem::exists(io::next_version(file)));
}
