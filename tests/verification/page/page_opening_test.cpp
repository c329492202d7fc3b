// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a page opens on what is worth seeing: the axis against gravity is up, the body that moves is
// the one that is charted, at the time when it is pushed hardest, pressure is gauge pressure and says
// so, and filtered peak forces and mendings are in its tables. Without Chromium and its driver this says
// that it was skipped.

#include <catch2/catch.hpp>

#include <fstream>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// A held plate, part 30, that feels 9 kN, and a head, part 20, that flies and is hit hardest in row 2.
void write_bodies(const fs::path& folder) {
    RecordLayout layout = scene::layout();
    layout.rigid_bodies = {30, 20};
    io::RunInfo info = scene::info();
    info.up = "-y";
    info.parts = {{20, "head"}, {30, "plate"}};
    info.ambient = {{7, 1e-4}, {9, 1e-4}};
    io::ResultsFile results(folder, info, layout);
    results.follow(0.5, {{20, 4.0, Vec3(0, 0, 100), Vec3(0, 0, -10)}});
    for (std::size_t k = 0; k < 4; ++k) {
        Sample sample = scene::sample(layout, k);
        sample.time = 1.5 * static_cast<double>(k);
        sample.rigid_bodies[0] = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3(0, 0, -9)};
        sample.rigid_bodies[1] = {Vec3(0, 0, 100 - 15.0 * static_cast<double>(k)), Vec3(0, 0, -10),
                                  Vec3::Zero(), Vec3(0, 0, k == 2 ? 3.0 : 1.0)};
        results.append(sample);
        results.write(scene::frame(layout, k, 5));
    }
    for (int step = 0; step <= 90; ++step)
        results.observe(0.05 * step,
                        {{Vec3(0, 0, 100 - 0.5 * step), Vec3(0, 0, -10), Vec3(0, 0, 1.0)}},
                        step == 90);
    results.finish("normal");
    std::ofstream(folder / "run.json")
        << R"({"wall": 1.0, "steps": 90, "phases": {}, "warnings": [], "mended": ["a lid"]})";
}

}  // namespace

TEST_CASE("a page opens on what is worth seeing", "[report]") {
    if (!test::Visit::is_possible()) return;
    const scene::Folder folder("opening_page");
    write_bodies(folder.path);
    const test::Visit seen("visit_opening.mjs", report::page({folder.path}), {}, folder.path);
    CHECK(seen["t"] == "3");
    CHECK(seen["up"] == "-y");
    CHECK(seen["charts"].find("\"bag 7: pressure, gauge\"") == 1);
    CHECK_THAT(seen["charts"], Catch::Contains("rigid body 20 \\\"head\\\": force, z") &&
                                   !Catch::Contains("rigid body 30"));
    for (const char* filter : {"60", "180", "600", "1000"})
        CHECK_THAT(seen["responses"], Catch::Contains(fmt::format("\"peak_force_cfc{}\"", filter)));
    CHECK(seen["mended"] == R"(["a lid"])");
    CHECK(seen["faults"] == "[]");
}
