// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the folded driver bag begins to open: no layer passes another, no particle is lost, and
// the books close.

#include <catch2/catch.hpp>

#include "tests/support/frame_crossings.hpp"
#include "tests/support/model_run.hpp"

using namespace corpuscle;

TEST_CASE("the folded driver bag opens without a crossing or a lost particle", "[model][folded]") {
    const test::ModelRun run("driver_bag_folded",
                             "-D NP=10000 -D ENDTIM=0.5 -D DTPLOT=0.05 --quiet");
    REQUIRE(run.status() == 0);
    const test::FrameCrossings found = test::frame_crossings(run.results());
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
