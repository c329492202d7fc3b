// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a run that is killed again and again, and restarted each time, ends in the same bits as
// one that was left alone.

#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "io/hdf5.hpp"

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

/// Starts the program; it is killed after `patience`, unless it has ended.
/// @returns its exit status, or -1 if it was killed
int run(const std::vector<std::string>& words, std::chrono::milliseconds patience) {
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
    const auto until = std::chrono::steady_clock::now() + patience;
    int status = 0;
    while (waitpid(child, &status, WNOHANG) == 0) {
        if (std::chrono::steady_clock::now() >= until) {
            kill(child, SIGKILL);
            waitpid(child, &status, 0);
            return -1;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

std::string text_of(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
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

}  // namespace

TEST_CASE("ten kills at random instants leave no trace in the results", "[restart]") {
    const auto scene = GENERATE(Scene{"driver_bag_flat", "NP=3000", "1.0", 20},
                                Scene{"vented_tank", "NP=2000", "0.02", 50},
                                Scene{"two_inflators", "NP=2000", "0.004", 50},
                                Scene{"porous_tank", "NP=2000", "0.02", 50});
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
    fs::copy_file(models / "mesh.k", folder / "mesh.k");

    const auto words = [&](const std::string& out) {
        std::vector<std::string> w = {"corpuscle",  "run", deck,          "-o",
                                      folder / out, "-D",  scene.options, "--quiet"};
        w.insert(w.end(), {"--until", scene.until});
        return w;
    };
    const auto begin = std::chrono::steady_clock::now();
    REQUIRE(run(words("whole"), std::chrono::minutes(2)) == 0);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;

    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(0.05, 0.5);
    int kills = 0;
    bool is_over = false;
    for (; kills < 10 && !is_over; ++kills) {
        auto w = words("broken");
        if (kills > 0) w.push_back("--restart");
        const auto patience =
            std::chrono::milliseconds(static_cast<int>(share(random) * took.count()));
        is_over = run(w, patience) == 0;
    }
    auto last = words("broken");
    last.push_back("--restart");
    REQUIRE(run(last, std::chrono::minutes(2)) == 0);
    CHECK(kills > 2);

    std::size_t compared = 0;
    const io::Hdf5Reader whole(folder / "whole/results.h5"), broken(folder / "broken/results.h5");
    CHECK(broken.text("/", "termination") == "normal");
    compare(whole, broken, "/", compared);
    CHECK(compared > 10000);
    CHECK(text_of(folder / "whole/glstat") == text_of(folder / "broken/glstat"));
    CHECK_FALSE(fs::exists(folder / "broken/checkpoint"));
}
