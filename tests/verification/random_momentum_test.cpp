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

#include "tests/support/random/random_scene.hpp"
#include "tests/support/runs/scene_momentum.hpp"
#include "tests/support/runs/scene_run.hpp"

using namespace corpuscle;
using corpuscle::test::SceneRun;

namespace {

constexpr double INFLOW_END = 0.4;  ///< of the time, at the latest

void run_free_scenes(int first, int last) {
    constexpr double SINGLE_PRECISION = 1e-6;
    for (int seed = first; seed <= last; ++seed) {
        const support::RandomScene scene = support::free_scene(static_cast<unsigned>(seed));
        const SceneRun run(fmt::format("free_scene_{}", seed), scene.deck,
                           fmt::format("--seed {}", scene.seed));
        std::string fault = run.fault(0.01 * (run.brought_in + run.held));
        const double change =
            run.status == 0 ? test::change_of_momentum(run.results(), INFLOW_END) : 0.0;
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
