// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a large run is small enough to send, opens without a fault or a request, and
// tells how long that takes; a page that comes slowly shows each frame when all of its bytes are
// there. Without Chromium and its driver this says that the opening was skipped.

#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

TEST_CASE("10 000 nodes, 20 000 particles and 40 frames make a page of 12 MB or less", "[report]") {
    constexpr int SIDE = 100, FRAMES = 40, PARTICLES = 20000;
    const scene::Folder folder("large_page");
    RecordLayout layout;
    layout.parts = {1};
    for (int i = 0; i < SIDE * SIDE; ++i) {
        layout.node_id.push_back(i + 1);
        layout.coordinates.emplace_back(i % SIDE, i / SIDE, 0.0);
        if (i % SIDE + 1 == SIDE || i / SIDE + 1 == SIDE) continue;
        layout.shell_id.push_back(i + 1);
        layout.shell_part.push_back(1);
        layout.shell_nodes.push_back({i, i + 1, i + SIDE + 1, i + SIDE});
    }
    const std::size_t shells = layout.shell_id.size();
    Sample sample;
    sample.parts.resize(1);
    io::ResultsFile results(folder.path, scene::info(), layout);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> in(0.0, 1.0);
    for (int k = 0; k < FRAMES; ++k) {
        sample.time = k;
        results.append(sample);
        Frame frame;
        frame.time = k;
        frame.velocity = frame.coordinates = layout.coordinates;
        for (Vec3& x : frame.coordinates)  // waves, with the noise that fabric has
            x.z() = k * (1.0 + std::sin(0.1 * x.x() + 0.2 * k)) + 0.02 * in(random);
        for (std::size_t s = 0; s < shells; ++s) {
            frame.shell_pressure.push_back(static_cast<float>(in(random)));
            const auto stress = static_cast<float>(in(random));
            frame.shell_stress.push_back({stress, 0.5F * stress, 0.0F});
            frame.shell_strain.push_back({0.0F, 0.0F, 0.0F});
            frame.shell_active.push_back(1);
        }
        Frame::Particles& gas = frame.particles.emplace();
        for (int p = 0; p < PARTICLES; ++p) {
            gas.id.push_back(p);
            gas.species.push_back(1);
            gas.bag.push_back(1);
            gas.position.emplace_back(100.0 * in(random), 100.0 * in(random), k * in(random));
            gas.velocity.emplace_back(in(random), in(random), in(random));
            gas.internal_energy.push_back(1.0);
            gas.mass.push_back(1.0);
            gas.temperature.push_back(static_cast<float>(in(random)));
        }
        results.write(frame);
    }
    results.finish("normal");
    const std::string page = report::page({folder.path});
    REQUIRE(page.size() < 12000000);
    if (!test::Visit::is_possible()) return;
    const test::Visit seen("visit_large.mjs", page, {}, folder.path);
    CHECK(std::stod(seen["ink"]) > 0.05);
    CHECK(seen["requests"] == "[]");
    CHECK(seen["faults"] == "[]");
    WARN(1e-6 * static_cast<double>(page.size())
         << " MB, first picture by a software renderer after " << seen["first"]
         << " s, opened again after " << seen["opened"] << " s");
}

TEST_CASE("a page that stops within a frame's bytes goes on when they come", "[report]") {
    if (!test::Visit::is_possible()) return;
    const scene::Folder folder("slow_page");
    test::write_results(folder.path);
    const test::Visit seen("visit_slow.mjs", report::page({folder.path}),
                           {"frame0_1", "frame0_2", "frame0_3"}, folder.path);
    CHECK(seen["read"] == R"({"frame0_1":[1,4],"frame0_2":[2,4],"frame0_3":[3,4]})");
    for (const char* frame : {"frame0_1", "frame0_2", "frame0_3"})
        CHECK_THAT(seen[fmt::format("state of {}", frame)], !Catch::Contains("cannot be shown"));
    CHECK(seen["faults"] == "[]");
}
