// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Scenes of several bags.
#include <catch2/catch.hpp>

#include "gas/particles.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

TEST_CASE("bags that are alike draw random numbers of their own, the first as if it were alone",
          "[solver][gas]") {
    Model alone = scenes::of(shapes::box({0.1, 0.1, 0.1}, 2), scenes::null_material(), 1e-3);
    scenes::fill(alone, scenes::air(), 1e-4, 1e-4, 300.0, {0.05, 0.05, 0.05}, 200);
    alone.bags[0].air = gas::InitialAirCard{scenes::air(), 1e5, 300.0, true};
    scenes::fix_all_nodes(alone);
    alone.end_time = 5e-4;
    Model twins = alone;
    twins.bags.push_back(alone.bags[0]);
    twins.bags[1].id = 2;
    Simulation one(alone), both(twins);
    const auto& of_one = one.bags()[0].particles();
    const auto& first = both.bags()[0].particles();
    const auto& second = both.bags()[1].particles();
    REQUIRE(first.size() > 50);
    REQUIRE(first.size() == second.size());
    const auto same = [](const gas::Particles& a, const gas::Particles& b) {
        std::size_t count = 0;
        for (std::size_t i = 0; i < a.size(); ++i) count += a.x[i] == b.x[i] && a.v[i] == b.v[i];
        return count;
    };
    CHECK(same(of_one, first) == first.size());
    CHECK(same(first, second) == 0);
    while (!both.is_over()) both.step([](Simulation&) {});
    REQUIRE(first.size() == second.size());
    CHECK(first.size() > of_one.size());
    CHECK(same(first, second) == 0);
}
