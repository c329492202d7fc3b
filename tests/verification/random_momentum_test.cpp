// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: momentum of a bag that nothing holds, of cloth, gas, what gas owes to cloth, and of a body
// that flies against it, is constant from the end of the inflow on; and what holds of every random
// scene. Frames have single precision.
//
//   CORPUSCLE_SCENES=1-500 verify_random_scenes "many free*"

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "io/results/hdf5.hpp"
#include "solver/base/vec.hpp"
#include "tests/support/decks/random_scene.hpp"
#include "tests/support/runs/scene_run.hpp"

using namespace corpuscle;
using corpuscle::test::SceneRun;

namespace {

constexpr double INFLOW_END = 0.4;  ///< of the time, at the latest

struct Momentum {
    Vec3 sum = Vec3::Zero();  ///< [kg m/s]
    double sizes = 0.0;       ///< of all that is in it                               [kg m/s]

    void add(const Vec3& p) {
        sum += p;
        sizes += p.norm();
    }
};

Vec3 row(const std::vector<double>& all, std::size_t i) {
    return {all[3 * i], all[3 * i + 1], all[3 * i + 2]};
}

/// Of a row of the history and the frame of the same time.
Momentum momentum_at(const io::Hdf5Reader& file, std::size_t i) {
    Momentum all;
    for (const std::string& part : file.names("/history/part"))
        all.add(row(file.read<double>("/history/part/" + part + "/momentum"), i));
    all.add(row(file.read<double>("/history/airbag/1/owed_momentum"), i));
    const std::string gas = fmt::format("/frames/{:05d}/particles", i);
    if (!file.has(gas)) return all;
    const auto v = file.read<double>(gas + "/velocity"), mass = file.read<double>(gas + "/mass");
    for (std::size_t k = 0; k < mass.size(); ++k) all.add(mass[k] * row(v, k));
    return all;
}

/// Greatest change since the inflow's end, of all that moves.
double change_of_momentum(const SceneRun& run) {
    const io::Hdf5Reader file(run.results());
    const auto time = file.read<double>("/history/time"),
               frames = file.read<double>("/frames/time");
    REQUIRE(time == frames);
    Momentum start;
    double worst = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] < INFLOW_END * time.back()) continue;
        const Momentum now = momentum_at(file, i);
        if (start.sizes == 0.0) start = now;
        worst = std::max(worst, (now.sum - start.sum).norm() / now.sizes);
    }
    return worst;
}

void run_free_scenes(int first, int last) {
    constexpr double SINGLE_PRECISION = 1e-6;
    for (int seed = first; seed <= last; ++seed) {
        const support::RandomScene scene = support::free_scene(static_cast<unsigned>(seed));
        const SceneRun run(fmt::format("free_scene_{}", seed), scene.deck,
                           fmt::format("--seed {}", scene.seed));
        std::string fault = run.fault(0.01 * (run.brought_in + run.held));
        const double change = run.status == 0 ? change_of_momentum(run) : 0.0;
        if (change > SINGLE_PRECISION)
            fault += fmt::format("momentum changes by {:.2g} of all that moves\n", change);
        fmt::print("free scene {}: {}: {:.1f} s, momentum {:.2g}\n{}", seed, scene.summary,
                   run.seconds, change, fault);
        std::fflush(stdout);
        INFO("free scene " << seed << ": " << scene.summary << "\n" << fault);
        CHECK(fault.empty());
    }
}

}  // namespace

TEST_CASE("free random scenes keep their momentum", "[scenes]") {
    run_free_scenes(1, 15);
}

TEST_CASE("many free random scenes keep their momentum", "[.full][scenes]") {
    const auto [first, last] = test::SceneRange::asked();
    run_free_scenes(first, last);
}
