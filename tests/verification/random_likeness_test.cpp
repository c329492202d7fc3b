// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a scene that is mirrored at a plane, with other node ids and its nodes and shells in
// another order, gives the same answer within chance. Six runs of each, every one with a seed of its
// own; of each number at the end of the run, Welch's t of the two means [Welch 1947] is below 12:
// with 5 degrees of freedom, the fewest there are, one in 14 000 is not.
//
//   CORPUSCLE_SCENES=1-200 verify_random_scenes "many mirrored*"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "tests/support/decks/mirrored.hpp"
#include "tests/support/random/random_scene.hpp"
#include "tests/support/runs/scene_run.hpp"

using namespace corpuscle;
using corpuscle::test::SceneRun;

namespace {

constexpr int RUNS = 6;
constexpr double FARTHEST = 12.0, LIKENESS = 1e-6;
constexpr int MOST_PARTICLES = 3000;

/// Some numbers at the end of each run, by path.
using Answers = std::map<std::string, std::vector<double>>;

void add(const SceneRun& run, Answers& all) {
    const io::Hdf5Reader file(run.results());
    for (const char* name : {"airbag/1/volume", "airbag/1/pressure", "airbag/1/temperature",
                             "airbag/1/mass", "airbag/1/mass_out_vent", "airbag/1/mass_out_fabric",
                             "energy/kinetic", "energy/strain", "energy/gas"}) {
        const std::string path = std::string("/history/") + name;
        if (file.has(path)) all[path].push_back(file.read<double>(path).back());
    }
}

struct Mean {
    double value = 0.0, variance = 0.0;  ///< of the mean
    explicit Mean(const std::vector<double>& all) {
        const auto n = static_cast<double>(all.size());
        for (const double a : all) value += a / n;
        for (const double a : all) variance += (a - value) * (a - value) / (n * (n - 1.0));
    }
};

/// Numbers that differ by more than chance, in words.
std::string differences(const Answers& one, const Answers& other) {
    std::string text;
    for (const auto& [path, values] : one) {
        const Mean a(values), b(other.at(path));
        const double apart = std::abs(a.value - b.value);
        if (apart <= LIKENESS * std::max(std::abs(a.value), std::abs(b.value))) continue;
        const double t = apart / std::sqrt(a.variance + b.variance);
        if (t > FARTHEST)
            text += fmt::format("{}: {:.6g}, mirrored {:.6g}: {:.1f} standard errors\n", path,
                                a.value, b.value, t);
    }
    return text;
}

void run_mirrored(int first, int last) {
    int scenes = 0;
    for (int seed = first; seed <= last; ++seed) {
        const support::RandomScene scene = support::random_scene(static_cast<unsigned>(seed));
        if (scene.particles > MOST_PARTICLES) continue;
        ++scenes;
        const std::string deck = support::triangulated(scene.deck);
        const std::string image = support::mirrored(deck, static_cast<unsigned>(seed));
        Answers answers, images;
        std::string fault;
        for (int k = 0; k < RUNS; ++k)
            for (const bool is_image : {false, true}) {
                const SceneRun run(fmt::format("mirrored_{}_{}_{}", seed, k, is_image ? 1 : 0),
                                   is_image ? image : deck,
                                   fmt::format("--seed {}", 2 * k + (is_image ? 2 : 1)));
                if (run.status == 0)
                    add(run, is_image ? images : answers);
                else
                    fault += fmt::format("status {}: {}", run.status, run.end);
            }
        if (fault.empty()) fault = differences(answers, images);
        fmt::print("mirrored scene {}: {}\n{}", seed, scene.summary, fault);
        std::fflush(stdout);
        INFO("mirrored scene " << seed << ": " << scene.summary << "\n" << fault);
        CHECK(fault.empty());
    }
    fmt::print("{} scenes, mirrored and renumbered\n", scenes);
}

}  // namespace

TEST_CASE("mirrored and renumbered random scenes give the same answer", "[scenes]") {
    run_mirrored(1, 12);
}

TEST_CASE("many mirrored and renumbered random scenes give the same answer", "[.full][scenes]") {
    const auto [first, last] = test::SceneRange::asked();
    run_mirrored(first, last);
}
