// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a run works in a real browser: the picture is not blank and moves with the
// slider, the curves hold the run's numbers, and no request leaves the file. Chromium opens the
// page with a script appended that does what a person would; without Chromium this says that it
// was skipped.

#include <zlib.h>

#include <catch2/catch.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#include "tests/unit/io/results_scene.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

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

/// Four frames of a small scene that grows; the first bag's pressure in each.
std::vector<double> write_results(const fs::path& folder) {
    const RecordLayout layout = scene::layout();
    io::ResultsFile results(folder, scene::info(), layout);
    std::vector<double> pressure;
    for (std::size_t k = 0; k < 4; ++k) {
        Sample sample = scene::sample(layout, k);
        sample.time = 1.5 * static_cast<double>(k);  // as the frames
        pressure.push_back(sample.airbags[0].pressure);
        results.append(sample);
        Frame frame = scene::frame(layout, k, 5);
        for (std::size_t n = 0; n < frame.coordinates.size(); ++n)
            frame.coordinates[n] = (1.0 + 0.2 * static_cast<double>(k)) * layout.coordinates[n];
        for (Vec3& x : frame.particles->position) x = 0.01 * x / x.norm();
        results.write(frame);
    }
    results.finish("normal");
    return pressure;
}

/// Waits until the page is there, draws, and says so.
constexpr const char* OPENED = R"(<script>
(async () => {
    while (!document.body.dataset.ready) await new Promise((go) => setTimeout(go, 50));
    window.page.draw();
    document.body.innerHTML = "<pre id=\"seen\">drawn=yes;</pre>";
})();
</script>)";

double seconds_to_open(const std::string& program, const fs::path& folder, const std::string& page,
                       std::string* dom = nullptr) {
    std::ofstream(folder / "opened.html") << page;
    const auto begin = std::chrono::steady_clock::now();
    const std::string text =
        run(report::dump_command(program, folder / "opened.html", folder / "profile"));
    if (dom != nullptr) *dom = text;
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

/// Width and height of a PNG, and how much of its packed lines is not 0: filtered, an even area is.
struct Png {
    std::uint32_t width = 0, height = 0;
    double ink = 0.0;

    explicit Png(const std::string& bytes) {
        REQUIRE(bytes.substr(0, 8) == "\x89PNG\r\n\x1a\n");
        const auto number = [&](std::size_t at) {
            std::uint32_t value = 0;
            for (std::size_t k = 0; k < 4; ++k)
                value = value << 8U | static_cast<unsigned char>(bytes.at(at + k));
            return value;
        };
        width = number(16);
        height = number(20);
        std::string packed;
        for (std::size_t at = 8; at + 12 <= bytes.size(); at += 12 + number(at))
            if (bytes.substr(at + 4, 4) == "IDAT") packed += bytes.substr(at + 8, number(at));
        std::string lines(static_cast<std::size_t>(height) * (1 + 4 * width), '\0');
        uLongf size = lines.size();
        REQUIRE(uncompress(reinterpret_cast<Bytef*>(lines.data()), &size,
                           reinterpret_cast<const Bytef*>(packed.data()), packed.size()) == Z_OK);
        lines.resize(size);
        ink = static_cast<double>(
                  std::count_if(lines.begin(), lines.end(), [](char c) { return c != 0; })) /
              static_cast<double>(size);
    }
};

}  // namespace

TEST_CASE("pictures of a run are drawn without a window and are not blank", "[report]") {
    if (report::browser().empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const scene::Folder folder("pictures");
    write_results(folder.path);
    const std::vector<report::Picture> all = report::pictures(report::page({folder.path}));
    constexpr double BLANK = 0.004;  // twice what the first line of an even area leaves
    REQUIRE(all.size() == 5);        // four frames and the strip
    for (std::size_t k = 0; k < 4; ++k) {
        CHECK(all[k].name == "picture_0" + std::to_string(k) + ".png");
        const Png png(all[k].bytes);
        CHECK((png.width == 640 && png.height == 480));
        CHECK(png.ink > BLANK);
        const bool moved = k == 0 || all[k].bytes != all[k - 1].bytes;
        CHECK(moved);
    }
    CHECK(all[4].name == "strip.png");
    const Png strip(all[4].bytes);
    CHECK((strip.width == 4 * 640 && strip.height == 480));
    CHECK(strip.ink > BLANK);
}

TEST_CASE("a run's page works in a browser", "[report]") {
    const std::string program = report::browser();
    if (program.empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const scene::Folder folder("page");
    const std::vector<double> pressure = write_results(folder.path);
    std::string page = report::page({folder.path});
    page.replace(page.rfind("</body>"), 0, VISITOR);
    std::ofstream(folder.path / "page.html") << page;
    const std::string dom =
        run(report::dump_command(program, folder.path / "page.html", folder.path / "profile"));
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
    CHECK(seen(dom, "clock") == "t = 4.5 ms");
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
    std::string page = report::page({folder.path});
    CHECK(page.size() < 12000000);
    const std::string program = report::browser();
    if (program.empty()) return;

    // how long an empty page takes is the browser's own start
    page.replace(page.rfind("</body>"), 0, OPENED);
    const double nothing = seconds_to_open(program, folder.path, "<body></body>");
    std::string dom;
    const double all = seconds_to_open(program, folder.path, page, &dom);
    CHECK(seen(dom, "drawn") == "yes");
    WARN(1e-6 * static_cast<double>(page.size())
         << " MB, opened and drawn by a software renderer in " << all - nothing
         << " s by the clock");
}
