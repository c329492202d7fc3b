// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a large run is small enough to send, and opens.

#include <catch2/catch.hpp>

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// Waits until the page is there, draws, and says so.
constexpr const char* OPENED = R"(<script>
(async () => {
    while (!document.body.dataset.ready) await new Promise((go) => setTimeout(go, 50));
    window.page.draw();
    document.body.innerHTML = "<pre id=\"seen\">drawn=yes;</pre>";
})();
</script>)";

constexpr const char* EMPTY =
    R"(<body><canvas></canvas><script>
const gl = document.querySelector("canvas").getContext("webgl2");
gl.clear(gl.COLOR_BUFFER_BIT);
gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
</script></body>)";

double seconds_to_open(const std::string& program, const fs::path& folder, const std::string& page,
                       std::string* dom = nullptr) {
    std::ofstream(folder / "opened.html") << page;
    const auto begin = std::chrono::steady_clock::now();
    const std::string text =
        test::printed_by(report::dump_command(program, folder / "opened.html", folder / "profile"));
    if (dom != nullptr) *dom = text;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

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
            gas.position.emplace_back(100.0 * in(random), 100.0 * in(random), k * in(random));
            gas.velocity.emplace_back(in(random), in(random), in(random));
            gas.internal_energy.push_back(1.0);
            gas.mass.push_back(1.0);
        }
        results.write(frame);
    }
    results.finish("normal");
    std::string page = report::page({folder.path});
    CHECK(page.size() < 12000000);
    const std::string program = report::browser();
    if (program.empty()) return;

    // how long a page of an empty picture takes is the browser's own start
    page.replace(page.rfind("</body>"), 0, OPENED);
    const double nothing = seconds_to_open(program, folder.path, EMPTY);
    std::string dom;
    const double all = seconds_to_open(program, folder.path, page, &dom);
    CHECK(test::seen(dom, "drawn") == "yes");
    WARN(1e-6 * static_cast<double>(page.size())
         << " MB, opened and drawn by a software renderer in " << all - nothing
         << " s by the clock");
}
