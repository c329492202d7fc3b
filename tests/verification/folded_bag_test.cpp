// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the folded driver bag begins to open: no layer passes another, no particle is lost, and
// the books close.

#include <catch2/catch.hpp>

#include "contact/intersections.hpp"
#include "io/hdf5.hpp"
#include "tests/support/model_run.hpp"

using namespace corpuscle;

TEST_CASE("the folded driver bag opens without a crossing or a lost particle", "[model][folded]") {
    const test::ModelRun run("driver_bag_folded",
                             "-D NP=10000 -D ENDTIM=0.5 -D DTPLOT=0.05 --quiet");
    REQUIRE(run.status() == 0);
    const io::Hdf5Reader file(run.results());
    const auto corners = file.read<std::int32_t>("/mesh/shell_nodes");
    std::vector<Triangle> triangles;
    for (std::size_t s = 0; s < corners.size(); s += 4) {
        triangles.push_back({corners[s], corners[s + 1], corners[s + 2]});
        if (corners[s + 2] != corners[s + 3])
            triangles.push_back({corners[s], corners[s + 2], corners[s + 3]});
    }
    const auto frame = [&](const std::string& name) {
        const auto x = file.read<double>("/frames/" + name + "/coordinates");
        Points points;
        for (std::size_t i = 0; i < x.size(); i += 3) points.emplace_back(x[i], x[i + 1], x[i + 2]);
        return points;
    };
    const contact::Patches patches = contact::make_patches(frame("00000"), triangles);
    std::size_t frames = 0;
    for (const std::string& name : file.names("/frames")) {
        if (name == "time") continue;
        INFO("frame " << name);
        CHECK(contact::crossings(triangles, patches, frame(name)).empty());
        ++frames;
    }
    CHECK(frames >= 11);

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
