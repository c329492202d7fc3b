// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a run works in a real browser: the picture is not blank and moves with the
// slider, the curves hold the run's numbers, and no request leaves the file. Chromium opens the
// page with a script appended that does what a person would; without Chromium this says that it
// was skipped.

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "tests/unit/io/results_scene.hpp"
#include "tools/report/page.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

std::string browser() {
    for (const char* name : {"chromium", "chromium-browser", "google-chrome"})
        if (std::system(("command -v " + std::string(name) + " > /dev/null").c_str()) == 0)
            return name;
    return "";
}

/// Moves the slider to the end, presses keys, and puts what it sees into the page's own text.
constexpr const char* VISITOR = R"(<pre id="seen"></pre><script>
// nobody looks at this window, so it is never painted by itself
window.requestAnimationFrame = (draw) => setTimeout(draw, 10);
const later = () => new Promise((go) => setTimeout(go, 50));
const ink = () => {
    const canvas = document.querySelector("#scene canvas.picture"), gl = canvas.getContext("webgl2");
    const pixels = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let inked = 0, sum = 0;
    for (let k = 0; k < pixels.length; k += 4)
        if (pixels[k] < 235) { ++inked; sum = (31 * sum + k + pixels[k + 1]) % 1000000007; }
    return [inked / (canvas.width * canvas.height), sum];
};
(async () => {
    while (!document.body.dataset.ready) await later();
    await later();
    const seen = [], slider = document.getElementById("slider");
    const note = (name, value) => seen.push(`${name}=${value};`);
    const chart = () => document.querySelector("#charts canvas").getAttribute("aria-label");
    const [inkStart, sumStart] = ink();
    note("ink", inkStart); note("start", chart());
    slider.value = 1000;
    slider.dispatchEvent(new Event("input"));
    await later();
    note("end", chart()); note("clock", document.getElementById("clock").textContent);
    note("moved", ink()[1] !== sumStart);
    document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "Home", bubbles: true}));
    await later();
    note("home", chart()); note("back", ink()[1] === sumStart);
    document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "c", bubbles: true}));
    await later();
    note("coloured", ink()[1] !== sumStart);
    note("requests", performance.getEntriesByType("resource").length);
    document.getElementById("seen").textContent = seen.join("");
})();
</script>)";

std::string run(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> part{};
    for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
        text.append(part.data(), n);
    ::pclose(pipe);
    return text;
}

/// name=...; of what the visitor saw.
std::string seen(const std::string& dom, const std::string& name) {
    const std::size_t list = dom.find("<pre id=\"seen\">");
    REQUIRE(list != std::string::npos);
    const std::size_t at = dom.find(name + "=", list);
    INFO(dom.substr(list, 600));
    REQUIRE(at != std::string::npos);
    return dom.substr(at + name.size() + 1, dom.find(';', at) - at - name.size() - 1);
}

/// As the page shows a number: five digits.
std::string shown(float value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.5g", static_cast<double>(value));
    return text.data();
}

}  // namespace

TEST_CASE("a run's page works in a browser", "[report]") {
    const std::string program = browser();
    if (program.empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const scene::Folder folder("page");
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder.path, scene::info(), layout);
    std::vector<double> pressure;
    for (std::size_t k = 0; k < 4; ++k) {
        const Sample sample = scene::sample(layout, k);
        pressure.push_back(sample.airbags[0].pressure);
        results.append(sample);
        Frame frame = scene::frame(layout, k, 5);
        for (std::size_t n = 0; n < frame.coordinates.size(); ++n)
            frame.coordinates[n] = (1.0 + 0.2 * static_cast<double>(k)) * layout.coordinates[n];
        for (Vec3& x : frame.particles->position) x = 0.01 * x / x.norm();
        results.write(frame);
    }
    results.finish("normal");

    std::string page = report::page({folder.path});
    page.replace(page.rfind("</body>"), 0, VISITOR);
    std::ofstream(folder.path / "page.html") << page;
    const std::string dom =
        run(program +
            " --headless --no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader "
            "--no-first-run"
            " --disable-background-networking --disable-component-update --disable-sync"
            " --user-data-dir=" +
            (folder.path / "profile").string() +
            " --window-size=1200,900 --virtual-time-budget=10000 --dump-dom file://" +
            (folder.path / "page.html").string() + " 2>/dev/null");
    CHECK(std::stod(seen(dom, "ink")) > 0.005);
    CHECK(seen(dom, "moved") == "true");
    CHECK(seen(dom, "back") == "true");
    CHECK(seen(dom, "coloured") == "true");
    CHECK(seen(dom, "requests") == "0");
    CHECK(seen(dom, "start") ==
          "airbag/7/pressure: " + shown(static_cast<float>(pressure.front())) + " GPa");
    CHECK(seen(dom, "end") ==
          "airbag/7/pressure: " + shown(static_cast<float>(pressure.back())) + " GPa");
    CHECK(seen(dom, "home") == seen(dom, "start"));
    CHECK(seen(dom, "clock") == "t = 1.5 ms");
}

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
    CHECK(report::page({folder.path}).size() < 12000000);
}
