// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a run works in a real browser: the picture is not blank and moves with the
// slider, the curves hold the run's numbers, and no request leaves the file. Chromium opens the
// page with a script appended that does what a person would; without Chromium this says that it
// was skipped.

#include <catch2/catch.hpp>

#include <array>
#include <fstream>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// Moves the slider to the end, presses keys, and puts what it sees into the page's own text.
constexpr const char* VISITOR = R"(<pre id="seen"></pre><script>
// nobody looks at this window, so it is never painted by itself
window.requestAnimationFrame = (draw) => setTimeout(draw, 10);
const pause = () => new Promise((go) => setTimeout(go, 50));
const later = async () => {
    await pause();
    for (const run of window.page.runs) await readFrame(run, frameAt(run, window.page.t));  // when it is asked for
    await pause();
};
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
    while (!document.body.dataset.ready) await pause();
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

/// As the page shows a number: five digits.
std::string shown(float value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.5g", static_cast<double>(value));
    return text.data();
}

}  // namespace

TEST_CASE("a run's page works in a browser", "[report]") {
    const std::string program = report::browser();
    if (program.empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const scene::Folder folder("page");
    const std::vector<double> pressure = test::write_results(folder.path);
    std::string page = report::page({folder.path});
    page.replace(page.rfind("</body>"), 0, VISITOR);
    std::ofstream(folder.path / "page.html") << page;
    const std::string dom = test::printed_by(
        report::dump_command(program, folder.path / "page.html", folder.path / "profile"));
    CHECK(std::stod(test::seen(dom, "ink")) > 0.005);
    CHECK(test::seen(dom, "moved") == "true");
    CHECK(test::seen(dom, "back") == "true");
    CHECK(test::seen(dom, "coloured") == "true");
    CHECK(test::seen(dom, "requests") == "0");
    CHECK(test::seen(dom, "start") ==
          "airbag/7/pressure: " + shown(static_cast<float>(pressure.front())) + " GPa");
    CHECK(test::seen(dom, "end") ==
          "airbag/7/pressure: " + shown(static_cast<float>(pressure.back())) + " GPa");
    CHECK(test::seen(dom, "home") == test::seen(dom, "start"));
    CHECK(test::seen(dom, "clock") == "t = 4.5 ms");
}
