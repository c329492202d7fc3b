// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/runs/scene_run.hpp"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "io/results/hdf5.hpp"
#include "tests/places.hpp"
#include "tests/support/runs/datasets.hpp"
#include "tests/support/runs/scene_outside.hpp"
#include "tools/verify/frame_crossings.hpp"

namespace corpuscle::test {
namespace {

namespace fs = std::filesystem;

constexpr int MOST_SECONDS = 60;  ///< of all cores, however loaded the machine is

/// Greatest size; infinite where one is no number.
double largest(const std::vector<double>& values) {
    double most = 0.0;
    for (const double v : values) most = std::max(most, std::isfinite(v) ? std::abs(v) : INFINITY);
    return most;
}

/// FNV-1a, 64 bits.
void add_to(std::uint64_t& digest, const void* bytes, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
        digest = (digest ^ static_cast<const unsigned char*>(bytes)[i]) * 0x100000001b3ULL;
}

/// What the shell is to run.
std::string command_of(const fs::path& directory, const std::string& options, SceneRun::How how) {
    const bool is_broken = how == SceneRun::How::RESTARTED;
    const std::string run = fmt::format("{} run scene.k -j {} -o out {}", CORPUSCLE_PROGRAM,
                                        how == SceneRun::How::TWO_THREADS ? 2 : 1, options);
    const std::string kill = fmt::format(
        "{{ {} >log 2>&1 & while kill -0 $! 2>/dev/null && [ ! -e out/checkpoint ]; do sleep "
        "0.002; "
        "done; kill -9 $! 2>/dev/null; wait $!; }} 2>/dev/null; ",
        run);
    return fmt::format("cd '{}' && ulimit -t {} && {} exec {}{} >log 2>&1", directory.string(),
                       MOST_SECONDS, is_broken ? kill : "", run, is_broken ? " --restart" : "");
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() &&
           text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

SceneRange SceneRange::asked() {
    SceneRange range;
    const char* text = std::getenv("CORPUSCLE_SCENES");
    if (text == nullptr) return range;
    const int read = std::sscanf(text, "%d-%d", &range.first, &range.last);
    if (read < 1) throw std::runtime_error("CORPUSCLE_SCENES: expected 31-93 or 500");
    return read == 2 ? range : SceneRange{1, range.first};
}

SceneRun::SceneRun(const std::string& name, const std::string& deck, const std::string& options,
                   How how)
    : name_(name), deck_(deck), options_(options) {
    if (const char* kept = std::getenv("KEEP")) {
        directory_ = fs::path(kept) / name;
        fs::create_directories(directory_);
    } else {
        std::string pattern = fs::temp_directory_path() / (name + ".XXXXXX");
        if (!mkdtemp(pattern.data())) throw std::runtime_error("no directory " + pattern);
        directory_ = pattern;
    }
    std::ofstream(directory_ / "scene.k") << deck;
    const auto start = std::chrono::steady_clock::now();
    const int ended = std::system(command_of(directory_, options, how).c_str());
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    status = WIFEXITED(ended) ? WEXITSTATUS(ended) : 128 + WTERMSIG(ended);
    read();
}

SceneRun::~SceneRun() {
    if (std::getenv("KEEP") != nullptr) return;
    std::error_code ignored;  // a directory left behind harms nobody
    fs::remove_all(directory_, ignored);
}

void SceneRun::read() {
    std::ifstream log(directory_ / "log");
    for (std::string line; std::getline(log, line);) {
        if (const auto at = line.find("lost particles: "); at != std::string::npos)
            lost = std::max(lost, std::atoi(line.c_str() + at + 16));
        if (status != 0 &&
            (line.rfind("corpuscle:", 0) == 0 || line.find(".k:") != std::string::npos) &&
            line.find("warning:") == std::string::npos)
            end += line + "\n";
    }
    if (!fs::exists(directory_ / "out/results.h5")) return;
    const io::Hdf5Reader file(directory_ / "out/results.h5");
    each_dataset(file, "/", [&](const std::string& path) {
        const auto values = file.read<double>(path);
        numbers += values.size();
        add_to(digest, path.data(), path.size());
        add_to(digest, values.data(), values.size() * sizeof(double));
        if (!all_finite(values) && not_finite.empty()) not_finite = path;
        const bool is_mass = ends_with(path, "/mass") || path.find("/mass_") != std::string::npos;
        if (is_mass && path.rfind("/history/", 0) == 0 && impossible.empty() &&
            std::any_of(values.begin(), values.end(), [](double v) { return v < 0.0; }))
            impossible = path;
        if (!ends_with(path, "/temperature") || !impossible.empty()) return;
        const auto mass = file.read<double>(path.substr(0, path.size() - 11) + "mass");
        for (std::size_t i = 0; i < mass.size(); ++i)
            if (mass[i] > 0.0 && !(values[i] > 0.0)) impossible = path;
    });
    const auto series = [&](const std::string& name) {
        const auto all = file.read<double>("/history/energy/" + name);
        return all.empty() ? std::vector<double>{0.0} : all;
    };
    crossings = verify::frame_crossings(directory_ / "out/results.h5").crossings;
    worst_residual = largest(series("residual"));
    under_way = largest(series("smoothing"));
    brought_in = series("inflow").back() + std::max(0.0, series("external").back());
    held = series("gas").front();
    strained = series("strain").front();
}

std::string SceneRun::fault(double residual) const {
    std::string text;
    if (status != 0)
        text += fmt::format("status {}: {}", status, end.empty() ? "no word why\n" : end);
    if (status == 0 && numbers == 0) text += "no results\n";
    if (!not_finite.empty()) text += not_finite + " is not finite\n";
    if (crossings != 0) text += fmt::format("{} pairs of facets cross\n", crossings);
    if (!impossible.empty()) text += impossible + " has a mass or temperature that no gas has\n";
    if (status == 0 && lost != 0) text += fmt::format("{} particles lost\n", lost);
    if (numbers > 0) {
        const Outside outside = particles_outside(directory_ / "scene.k", results());
        if (outside.particles != 0)
            text += fmt::format("{} of {} particles in all frames are outside of their bag\n",
                                outside.particles, outside.seen);
    }
    if (!(worst_residual <= residual))
        text += fmt::format("residual {:.3g} J; {:.3g} J were brought in, the gas held {:.3g} J\n",
                            worst_residual, brought_in, held);
    if (!(under_way < brought_in + held))
        text += fmt::format("{:.3g} J under way to the fabric, of {:.3g} J that there are\n",
                            under_way, brought_in + held);
    return text;
}

std::string SceneRun::differences(How how, int steps) const {
    std::string deck = deck_;
    if (how == How::RESTARTED)
        deck.insert(deck.rfind("*END"), fmt::format("*DATABASE_BINARY_D3DUMP\n{}\n", steps));
    const SceneRun again(name_ + "_again", deck, options_, how);
    if (again.status == status && again.digest == digest) return "";
    return fmt::format("other bits {} (status {}): {}\n",
                       how == How::RESTARTED ? "after a restart" : "on two threads", again.status,
                       again.end);
}

}  // namespace corpuscle::test
