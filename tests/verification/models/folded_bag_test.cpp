// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the folded driver bag begins to open: no layer passes another, no particle is lost, and
// the books close.

#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/runs/model_run.hpp"
#include "tools/verify/frame_crossings.hpp"

using namespace corpuscle;

TEST_CASE("the folded driver bag opens without a crossing or a lost particle", "[model][folded]") {
    const test::ModelRun run("driver_bag_folded",
                             "-D NP=10000 -D ENDTIM=0.5 -D DTPLOT=0.05 --quiet");
    REQUIRE(run.status() == 0);
    const verify::FrameCrossings found = verify::frame_crossings(run.results());
    CHECK(found.frames >= 11);
    CHECK(found.crossings == 0);

    const double inflow = run.at("/history/energy/inflow", 0.5);
    CHECK(inflow > 0.0);
    CHECK(std::abs(run.at("/history/energy/residual", 0.5)) < 0.01 * inflow);
    const auto volume = run.history("/history/airbag/1/volume");
    CHECK(volume.back() > 1.05 * volume.front());
    const double in = run.at("/history/airbag/1/mass_in", 0.5),
                 inside = run.at("/history/airbag/1/particles", 0.5),
                 out = run.at("/history/airbag/1/particles_out", 0.5);
    const auto mass = run.at("/history/airbag/1/species/1/mass", 0.5);
    CHECK(mass / in == Approx(inside / (inside + out)).epsilon(1e-9));  // none was lost
}

namespace {

/// Standard deviation over the mean.
double spread(const std::vector<double>& values) {
    double mean = 0.0, square = 0.0;
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (const double v : values) square += (v - mean) * (v - mean);
    return std::sqrt(square / static_cast<double>(values.size() - 1)) / mean;
}

}  // namespace

TEST_CASE("the folded driver bag opens alike with all seeds, in steps of its shells",
          "[.full][model][folded]") {
    std::vector<double> at_20, at_30;
    fmt::print("seed  steps  stopped tangles sweeps residual  20 ms, 30 ms [kPa]  volume [l]\n");
    for (int seed = 1; seed <= 8; ++seed) {
        const test::ModelRun run("driver_bag_folded",
                                 fmt::format("-D TSW=15 --quiet --seed {}", seed));
        REQUIRE(run.status() == 0);
        const verify::FrameCrossings found = verify::frame_crossings(run.results());
        CHECK(found.crossings == 0);
        at_20.push_back(1e6 * run.mean("/history/airbag/1/pressure", 19.5, 20.5));
        at_30.push_back(1e6 * run.mean("/history/airbag/1/pressure", 29.0, 30.0));
        fmt::print("{:>4} {:>6} {:>8} {:>7} {:>6.1f} {:>8.4f}  {:.2f}, {:.2f}  {:.2f}\n", seed,
                   run.of_run("steps"), run.of_run("pairs_stopped"), run.of_run("tangles"),
                   run.of_run("sweeps"), run.of_run("residual"), at_20.back(), at_30.back(),
                   1e-6 * run.history("/history/airbag/1/volume").back());
        std::fflush(stdout);
        CHECK(run.of_run("steps") < 4800);
        CHECK(run.of_run("pairs_stopped") < 200);
    }
    fmt::print("spread at 20 ms {:.2f} %, at 30 ms {:.2f} %\n", 100.0 * spread(at_20),
               100.0 * spread(at_30));
    CHECK(spread(at_20) < 0.005);
    CHECK(spread(at_30) < 0.005);
}

TEST_CASE("layers of the folded driver bag do not cross at any step", "[.full][model][folded]") {
    const test::ModelRun run("driver_bag_folded", "-D ENDTIM=5 -D DTPLOT=1e-6 -D NP=20000 --quiet");
    REQUIRE(run.status() == 0);
    const verify::FrameCrossings found = verify::frame_crossings(run.results());
    fmt::print("{} frames, {} crossings\n", found.frames, found.crossings);
    CHECK(static_cast<double>(found.frames) >= run.of_run("steps"));
    CHECK(found.crossings == 0);
}
