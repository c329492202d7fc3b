// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: any bag that can be folded comes out: what holds of every random scene, and in each scene
// the same bits on two threads and after a kill and a restart; gas that came in is inside or went
// out; momentum of a bag that nothing holds is constant from the inflow's end on.
//
//   CORPUSCLE_SCENES=1-100 verify_random_scenes "many folded*"

#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <string>

#include "io/results/hdf5.hpp"
#include "tests/support/random/folded_scene.hpp"
#include "tests/support/runs/scene_momentum.hpp"
#include "tests/support/runs/scene_run.hpp"

using namespace corpuscle;
using corpuscle::test::SceneRun;

namespace {

/// Gas that nobody can account for, at worst, over all that there was.
double lost_mass(const SceneRun& run) {
    const io::Hdf5Reader file(run.results());
    const auto bag = [&](const char* name) {
        return file.read<double>(std::string("/history/airbag/1/") + name);
    };
    const auto mass = bag("mass"), in = bag("mass_in"), by_vents = bag("mass_out_vent"),
               by_cloth = bag("mass_out_fabric");
    double worst = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const double there = mass[i] + by_vents[i] + by_cloth[i], was = mass[0] - in[0] + in[i];
        worst = std::max(worst, std::abs(there - was));
    }
    return worst / (mass[0] + in.back());
}

/// Of the bag as a chamber: the most that a history of it differs from the bag's, over the largest.
double chamber_apart(const SceneRun& run) {
    const io::Hdf5Reader file(run.results());
    const std::string bag = "/history/airbag/1/", chamber = bag + "chamber/1/";
    if (!file.has(chamber + "mass")) return 0.0;
    double worst = 0.0;
    for (const char* name : {"volume", "mass", "energy", "pressure"}) {
        const auto all = file.read<double>(bag + name), own = file.read<double>(chamber + name);
        const double most = *std::max_element(all.begin(), all.end());
        for (std::size_t i = 0; i < all.size(); ++i)
            worst = std::max(worst, std::abs(own[i] - all[i]) / most);
    }
    return worst;
}

std::string balances(const support::FoldedScene& scene, const SceneRun& run) {
    constexpr double ROUNDING = 1e-9, SINGLE_PRECISION = 1e-6;
    std::string fault;
    if (const double lost = lost_mass(run); !(lost < ROUNDING))
        fault += fmt::format("{:.2g} of the gas is not accounted for\n", lost);
    if (const double apart = chamber_apart(run); !(apart < ROUNDING))
        fault += fmt::format("the bag's only chamber is {:.2g} of the bag's state apart\n", apart);
    if (!scene.is_free) return fault;
    if (const double change = test::change_of_momentum(run.results(), 0.4);
        !(change < SINGLE_PRECISION))
        fault += fmt::format("momentum changes by {:.2g} of all that moves\n", change);
    return fault;
}

void run_folded_scenes(int first, int last) {
    constexpr int STEPS = 200;  ///< between checkpoints
    int faults = 0, refused = 0;
    for (int seed = first; seed <= last; ++seed) {
        const support::FoldedScene scene = support::folded_scene(static_cast<unsigned>(seed));
        const SceneRun run(fmt::format("folded_scene_{}", seed), scene.deck,
                           fmt::format("--seed {}", scene.seed));
        // what the bends of a pack hold is spent as what comes in is
        const double of = run.brought_in + run.strained;
        std::string fault = run.fault(0.01 * of);
        if (run.status == 0) {
            fault += balances(scene, run);
            fault += run.differences(SceneRun::How::TWO_THREADS, STEPS);
            fault += run.differences(SceneRun::How::RESTARTED, STEPS);
        }
        fmt::print("folded scene {}: {}: {:.1f} s, residual {:.2g} %\n{}", seed, scene.summary,
                   run.seconds, 100.0 * run.worst_residual / of, fault);
        std::fflush(stdout);
        faults += fault.empty() ? 0 : 1;
        refused += static_cast<int>(scene.refused.size());
        for (const std::string& why : scene.refused)
            fmt::print("  a recipe was refused: {}\n", why);
        INFO("folded scene " << seed << ": " << scene.summary << "\n" << fault << scene.recipe);
        CHECK(fault.empty());
    }
    fmt::print("{} of {} folded scenes with a fault; {} recipes refused and drawn anew\n", faults,
               last - first + 1, refused);
    CHECK(4 * refused <= last - first + 4);  // few, or the generator draws what nobody folds
}

}  // namespace

TEST_CASE("folded random scenes run to their end", "[scenes]") {
    run_folded_scenes(1, 3);
}

TEST_CASE("many folded random scenes run to their end", "[.full][scenes]") {
    const auto [first, last] = test::SceneRange::asked();
    run_folded_scenes(first, last);
}
