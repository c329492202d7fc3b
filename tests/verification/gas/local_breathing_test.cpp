// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: soft cloth round a gas at rest comes to rest: it does not gain by breathing.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "tests/support/case_report.hpp"
#include "tests/support/decks/free_bag.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

TEST_CASE("a soft sphere that breathes comes to rest", "[breathing]") {
    free_bag::Bag bag;
    bag.shape = shapes::sphere(0.1, 3);
    bag.p = 1.4 * air::P_ATM;
    bag.stiffness = 3e7;
    bag.end = 40e-3;
    bag.frames = 0.1e-3;
    const DeckRun run("breathing", free_bag::deck(bag));
    REQUIRE(run.status() == 0);
    const auto time = run.time(), kinetic = run.read("/history/energy/kinetic");
    constexpr std::size_t SPANS = 8;  // that the run is cut into
    std::vector<double> mean(SPANS, 0.0);
    const std::size_t each = time.size() / SPANS;
    for (std::size_t k = 0; k < SPANS; ++k) {
        for (std::size_t i = k * each; i < (k + 1) * each; ++i)
            mean[k] += kinetic[i] / static_cast<double>(each);
        report(fmt::format("breathing: kinetic energy of {:.0f} to {:.0f} ms [J]",
                           1e3 * time[k * each], 1e3 * time[(k + 1) * each - 1]),
               0.0, mean[k]);
    }
    for (std::size_t k = 1; k < SPANS; ++k) CHECK(mean[k] < mean[k - 1]);
    CHECK(mean.back() < 0.5 * mean.front());
}
