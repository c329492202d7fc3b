// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a run that is killed again and again, and restarted each time, ends in the same bits as
// one that was left alone.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>
#include <thread>

#include "io/results/hdf5.hpp"
#include "tests/places.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

class Folder {
public:
    Folder() {
        std::string pattern = fs::temp_directory_path() / "restart.XXXXXX";
        REQUIRE(mkdtemp(pattern.data()) != nullptr);
        path_ = pattern;
    }
    ~Folder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] fs::path operator/(const std::string& name) const { return path_ / name; }

private:
    fs::path path_;
};

pid_t start(const std::vector<std::string>& words) {
    std::fflush(nullptr);  // or the child would write it again
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
        static_cast<void>(!std::freopen("/dev/null", "w", stdout));
        static_cast<void>(!std::freopen("/dev/null", "w", stderr));
        std::vector<char*> argv;
        for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
        argv.push_back(nullptr);
        execv(CORPUSCLE_PROGRAM, argv.data());
        _exit(127);
    }
    return child;
}

/// When to kill: so many checkpoints after the start, and a share of the time that one took later.
/// By progress, not by the clock, for that a restart takes is not to eat up what was left.
struct Instant {
    int checkpoints;
    double share;
};

/// Runs the program, and kills it at an instant unless it has ended by then.
/// @returns its exit status, or -1 if it was killed
int run(const std::vector<std::string>& words, const fs::path& checkpoint, const Instant& instant) {
    using Clock = std::chrono::steady_clock;
    const pid_t child = start(words);
    std::error_code none;
    auto last = fs::last_write_time(checkpoint, none);
    auto since = Clock::now(), until = Clock::time_point::max();
    int status = 0;
    for (int seen = 0; waitpid(child, &status, WNOHANG) == 0;) {
        const auto now = Clock::now();
        if (now >= until) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return -1;
        }
        if (const auto written = fs::last_write_time(checkpoint, none); written != last) {
            last = written;
            const std::chrono::duration<double> took = now - since;
            since = now;
            if (++seen == instant.checkpoints)
                until = now + std::chrono::duration_cast<Clock::duration>(
                                  (seen > 1 ? instant.share : 0.1 * instant.share) * took);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(500));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

int run_whole(const std::vector<std::string>& words) {
    int status = 0;
    waitpid(start(words), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

/// Requires that all numbers below a group are the same bits.
void compare(const io::Hdf5Reader& a, const io::Hdf5Reader& b, const std::string& group,
             std::size_t& compared) {
    REQUIRE(a.names(group) == b.names(group));
    for (const std::string& name : a.names(group)) {
        const std::string path = group == "/" ? "/" + name : group + "/" + name;
        if (a.is_group(path)) {
            compare(a, b, path, compared);
            continue;
        }
        INFO(path);
        REQUIRE(a.shape(path) == b.shape(path));
        const auto left = a.read<double>(path), right = b.read<double>(path);
        REQUIRE(std::memcmp(left.data(), right.data(), left.size() * sizeof(double)) == 0);
        compared += left.size();
    }
}

struct Scene {
    std::string model, options, until;
    int steps_between;  ///< checkpoints
};

/// Of a run that is killed again and again.
struct Broken {
    int kills = 0;
    std::size_t compared = 0;  ///< numbers, each the same as in the whole run
};

/// Runs a deck once as a whole, and once with up to ten kills; requires that both end alike.
Broken break_and_compare(const Folder& folder, const std::string& deck, const std::string& option,
                         const std::string& until) {
    const auto words = [&](const std::string& out, int threads) {
        return std::vector<std::string>{"corpuscle",  "run",     deck,   "-o",
                                        folder / out, "-D",      option, "--until",
                                        until,        "--quiet", "-j",   std::to_string(threads)};
    };
    REQUIRE(run_whole(words("whole", 1)) == 0);

    std::mt19937 random(7);
    Broken broken;
    for (; broken.kills < 10; ++broken.kills) {
        auto w = words("broken", 1 + static_cast<int>(random() % 2));
        if (broken.kills > 0) w.push_back("--restart");
        const Instant instant{1 + static_cast<int>(random() % 3),
                              static_cast<double>(random()) / 4294967296.0};
        const int status = run(w, folder / "broken/checkpoint", instant);
        if (status == 0) break;  // it was over sooner
        REQUIRE(status == -1);
    }
    auto last = words("broken", 2);
    last.push_back("--restart");
    REQUIRE(run_whole(last) == 0);

    const io::Hdf5Reader all(folder / "whole/results.h5"), parts(folder / "broken/results.h5");
    CHECK(parts.text("/", "termination") == "normal");
    compare(all, parts, "/", broken.compared);
    CHECK(text_of(folder / "whole/glstat") == text_of(folder / "broken/glstat"));
    CHECK_FALSE(fs::exists(folder / "broken/checkpoint"));
    return broken;
}

/// A shell that is stretched, let go by a half and stretched again: its yarns unload on curves of
/// their own, and its liner bears pressure once it has been taut. kg, mm, ms.
constexpr const char* UNLOADING = R"(*KEYWORD
*CONTROL_TERMINATION
600.0
*DATABASE_GLSTAT
1.0
*DATABASE_BINARY_D3DUMP
1000
*NODE
1,0.,0.,0.
2,10.,0.,0.
3,10.,10.,0.
4,0.,10.,0.
*ELEMENT_SHELL
1,1,1,2,3,4
*PART
cloth
1,1,1
*SECTION_SHELL
1,9
0.3,0.3,0.3,0.3
*MAT_FABRIC
1,7.0E-7,0.3,0.3,,0.0
0.03,,,0,0.02,0.3,0.1,0.05
0,0,0,0,1,14,0,0
0,0,0,0,0,0,0,0
0,0,0,0,0,0,0,0
10,10,0,11,11,0,0.0
*DEFINE_CURVE
10
0.0,0.0
0.1,0.03
0.2,0.06
*DEFINE_CURVE
11
0.0,0.0
0.05,0.005
0.1,0.03
*BOUNDARY_SPC_NODE
1,0,1,1,1
4,0,1,0,1
2,0,0,1,1
3,0,0,0,1
*BOUNDARY_PRESCRIBED_MOTION_NODE
2,1,2,20,1.0
3,1,2,20,1.0
*DEFINE_CURVE
20
0.0,0.0
60.0,1.0
300.0,0.4
600.0,0.9
*END
)";

}  // namespace

TEST_CASE("ten kills at random instants leave no trace in the results", "[restart]") {
    // 48 checkpoints each or more, of which one to three lie between two kills
    const auto scene = GENERATE(
        Scene{"driver_bag_folded", "NP=5000", "1.0", 3},
        Scene{"driver_bag_flat", "NP=3000", "1.0", 2}, Scene{"vented_tank", "NP=2000", "0.02", 10},
        Scene{"two_inflators", "NP=2000", "0.012", 4}, Scene{"porous_tank", "NP=2000", "0.02", 12});
    INFO(scene.model);
    const Folder folder;
    // the deck asks for checkpoints by steps, as a test has no time for those by the clock
    const fs::path models = fs::path(CORPUSCLE_MODELS) / scene.model;
    const std::string deck = folder / (scene.model + ".k");
    std::string text = text_of(models / (scene.model + ".k"));
    text.insert(text.rfind("*END"), "*DATABASE_BINARY_D3DUMP\n" +
                                        std::to_string(scene.steps_between) +
                                        "\n*DATABASE_GLSTAT\n0.01\n");
    std::ofstream(deck) << text;
    for (const char* included : {"mesh.k", "module.k"})
        if (fs::exists(models / included)) fs::copy_file(models / included, folder / included);
    const Broken broken = break_and_compare(folder, deck, scene.options, scene.until);
    CHECK(broken.kills > 5);
    CHECK(broken.compared > 10000);
    fmt::print("{}: {} kills, {} numbers the same bits\n", scene.model, broken.kills,
               broken.compared);
}

TEST_CASE("kills leave no trace in what cloth remembers of its loading", "[restart][fabric]") {
    const Folder folder;
    const std::string deck = folder / "unloading.k";
    std::ofstream(deck) << UNLOADING;
    const Broken broken = break_and_compare(folder, deck, "UNITS=kg-mm-ms", "600");
    CHECK(broken.kills > 5);
    CHECK(broken.compared > 5000);
}
