// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fcntl.h>
#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <csignal>
#include <fstream>
#include <functional>
#include <iostream>
#include <random>

#include "io/results/hdf5.hpp"
#include "io/results/results_file.hpp"
#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"

using namespace corpuscle;
using io::Hdf5Reader;
using io::ResultsFile;

/// A file on a full disk is abandoned on purpose (see ~Hdf5Writer): no leak to report, when
/// sanitized.
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libhdf5";
}

namespace {

/// A process that runs `body(go)`; `go` tells the parent that the interesting part begins.
class Child {
public:
    explicit Child(const std::function<void(const std::function<void()>& go)>& body) {
        int ends[2];
        REQUIRE(pipe(ends) == 0);
        std::cout.flush();
        std::fflush(nullptr);  // or the child's exit prints what the parent has yet to print
        id_ = fork();
        REQUIRE(id_ >= 0);
        if (id_ == 0) {
            try {
                body([&] { static_cast<void>(!write(ends[1], "g", 1)); });
            } catch (const std::exception&) {
                _exit(2);
            }
            _exit(0);
        }
        close(ends[1]);
        char ready = 0;
        static_cast<void>(!read(ends[0], &ready, 1));
        close(ends[0]);
    }
    void kill() const { ::kill(id_, SIGKILL); }
    /// Exit status, or -signal.
    [[nodiscard]] int wait() const {
        int status = 0;
        waitpid(id_, &status, 0);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }

private:
    pid_t id_;
};

/// Writes without a pause, so that a version of results.h5 is always under way, then gathers and
/// waits.
void write_without_a_pause(const std::filesystem::path& folder, const std::function<void()>& go) {
    const RecordLayout layout = scene::layout();
    ResultsFile results(folder, scene::info(), layout);
    go();
    for (std::size_t row = 0; row < 12; ++row) {
        results.append(scene::sample(layout, row));
        results.flush();
        if (row % 3 == 0) results.write(scene::frame(layout, row / 3, 20));
    }
    results.finish("normal");
    pause();
}

/// All that results.h5 holds is whole, and what was written.
void expect_whole(const std::filesystem::path& folder) {
    const Hdf5Reader file(folder / "results.h5");
    const RecordLayout layout = scene::layout();
    const auto times = file.read<double>("/history/time");
    const auto pressure = file.read<double>("/history/airbag/9/pressure");
    const auto velocity = file.read<double>("/history/node/105/velocity");
    REQUIRE(pressure.size() == times.size());
    REQUIRE(velocity.size() == 3 * times.size());
    for (std::size_t row = 0; row < times.size(); ++row) {
        const Sample s = scene::sample(layout, row);
        REQUIRE(times[row] == s.time);
        REQUIRE(pressure[row] == s.airbags[1].pressure);
        REQUIRE(velocity[3 * row + 2] == s.node_velocity[1].z());
    }
    CHECK(file.read<std::int32_t>("/mesh/node_id") == layout.node_id);
    const auto frames = file.read<double>("/frames/time");
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Frame f = scene::frame(layout, i, 20);
        const std::string at = "/frames/" + io::frame_name(i);
        REQUIRE(frames[i] == f.time);
        REQUIRE(file.read<float>(at + "/shell_pressure") == f.shell_pressure);
        REQUIRE(file.read<double>(at + "/particles/mass") == f.particles->mass);
    }
    const std::string termination = file.text("/", "termination");
    CHECK((termination == "running" || termination == "normal"));
}

}  // namespace

TEST_CASE("a run killed at any instant leaves results that open and are whole", "[io]") {
    std::mt19937 random{
        std::random_device{}()};  // the kills' instants vary with the machine anyway
    std::uniform_int_distribution<useconds_t> microseconds(0, 40000);
    constexpr int KILLS = 25;
    for (int kill = 0; kill < KILLS; ++kill) {
        const scene::Folder folder("kill");
        const Child child(
            [&](const std::function<void()>& go) { write_without_a_pause(folder.path, go); });
        usleep(microseconds(random));
        child.kill();
        REQUIRE(child.wait() == -SIGKILL);
        expect_whole(folder.path);
    }
}

/// No file may grow beyond this: as good as a full disk.                              [byte]
void limit_files(rlim_t size) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    getrlimit(RLIMIT_FSIZE, &limit);
    limit.rlim_cur = std::min(size, limit.rlim_max);
    setrlimit(RLIMIT_FSIZE, &limit);
}

bool fails_for_size(const std::function<void()>& action) {
    try {
        action();
    } catch (const SystemError& error) {
        return std::string(error.what()).find("File too large") != std::string::npos;
    }
    return false;
}

TEST_CASE("a full disk is an error with its reason and leaves the last good version", "[io]") {
    const scene::Folder folder("full");
    const bool recovers = GENERATE(false, true);
    // what no longer fits: a frame, the versions with many rows, a first byte of anything
    const rlim_t limit = GENERATE(300000, 60000, 4096, 0);
    const Child child([&](const std::function<void()>&) {
        const RecordLayout layout = scene::layout();
        ResultsFile results(folder.path, scene::info(), layout);
        results.append(scene::sample(layout, 0));
        results.write(scene::frame(layout, 0, 20));
        results.flush();
        limit_files(limit);
        bool fails = fails_for_size([&] {
            results.write(scene::frame(layout, 1, 20000));
            results.settle();
        });
        for (std::size_t row = 1; row < 100; ++row)  // on a slow day an append flushes, and fails
            fails_for_size([&] { results.append(scene::sample(layout, row)); });
        if (limit < 100000) fails = fails && fails_for_size([&] { results.flush(); });
        if (recovers) {
            limit_files(RLIM_INFINITY);
            results.write(scene::frame(layout, 1, 20));
            results.finish("normal");
        }
        std::exit(fails ? 42 : 43);  // through every clean-up there is
    });
    CHECK(child.wait() == 42);
    expect_whole(folder.path);
    const Hdf5Reader file(folder.path / "results.h5");
    CHECK(file.shape("/frames/time") == io::Shape{recovers ? 2U : 1U});
    CHECK(file.shape("/history/time") == io::Shape{recovers ? 100U : 1U});
}

namespace {

constexpr int NO_DISK = 77;  ///< of a process that may not mount one

/// A disk of this size that this process alone sees; false where the system does not allow that.
bool mount_disk(const std::filesystem::path& at, const char* size) {
    if (unshare(CLONE_NEWNS) != 0) {
        const auto user = getuid();
        if (unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
        std::ofstream("/proc/self/uid_map") << "0 " << user << " 1";
    }
    if (mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
    return mount("none", at.c_str(), "tmpfs", 0, (std::string("size=") + size).c_str()) == 0;
}

void fill_disk(const std::filesystem::path& file) {
    const int out = open(file.c_str(), O_CREAT | O_WRONLY, 0600);
    const std::string block(4096, '.');
    while (write(out, block.data(), block.size()) > 0) {
    }
    close(out);
}

}  // namespace

TEST_CASE("a disk that fills up during a run takes all histories and the reason", "[io]") {
    const scene::Folder disk("disk"), kept("kept");
    std::filesystem::create_directories(disk.path);
    const Child child([&](const std::function<void()>&) {
        if (!mount_disk(disk.path, "2m")) std::exit(NO_DISK);
        const auto folder = disk.path / "bag.out";
        const RecordLayout layout = scene::layout();
        ResultsFile results(folder, scene::info(), layout);
        results.append(scene::sample(layout, 0));
        results.write(scene::frame(layout, 0, 6000));  // more than the room that is held
        results.flush();
        fill_disk(disk.path / "of_others");
        for (std::size_t row = 1; row < 30; ++row) {
            try {
                results.append(scene::sample(layout, row));
            } catch (const SystemError&) {  // on a slow day an append flushes
            }
        }
        std::string reason;
        try {
            results.write(scene::frame(layout, 1, 2000));
            results.settle();
        } catch (const SystemError& error) {
            reason = error.what();
        }
        try {
            results.finish("error: " + reason);
            reason += ", but gathered";
        } catch (const SystemError& error) {
            reason += error.what();
        }
        std::filesystem::copy(folder, kept.path, std::filesystem::copy_options::recursive);
        const bool is_told =
            reason.find("cannot") == 0 && reason.find("no room in") != std::string::npos;
        std::exit(is_told ? 42 : 43);
    });
    const int status = child.wait();
    if (status == NO_DISK) {
        WARN("skipped: no disk may be mounted here");
        return;
    }
    CHECK(status == 42);
    const Hdf5Reader file(kept.path / "results.h5");
    CHECK(file.shape("/history/time") == io::Shape{30});
    CHECK_THAT(file.text("/", "termination"),
               Catch::Contains("error: cannot") && Catch::Contains("No space left"));
    CHECK(file.shape("/frames/time") == io::Shape{1});
    CHECK(file.read<std::int32_t>("/mesh/node_id") == scene::layout().node_id);
    CHECK(std::filesystem::exists(kept.path / "results.parts/mesh.h5"));
}
