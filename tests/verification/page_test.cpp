// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a run, or of two, works in a real browser: the pictures are not blank, move
// with the slider and are cut, the curves hold the runs' numbers, and no request leaves the file.
// Chromium opens the page with a script appended that does what a person would; without Chromium
// this says that it was skipped.

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
const pictures = () => [...document.querySelectorAll("#scene canvas.picture")];
const ink = (canvas) => {
    const gl = canvas.getContext("webgl2");
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
    const start = pictures().map((one) => ink(one));
    const differ = () => pictures().every((one, k) => ink(one)[1] !== start[k][1]);
    note("pictures", start.length);
    note("ink", Math.min(...start.map((of) => of[0]))); note("start", chart());
    slider.value = 1000;
    slider.dispatchEvent(new Event("input"));
    await later();
    note("end", chart()); note("clock", document.getElementById("clock").textContent);
    note("moved", differ());
    document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "Home", bubbles: true}));
    await later();
    note("home", chart()); note("back", ink(pictures()[0])[1] === start[0][1]);
    const cut = document.getElementById("cut");
    cut.value = 500;
    cut.dispatchEvent(new Event("input"));
    await later();
    note("cut", differ());
    cut.value = 1000;
    cut.dispatchEvent(new Event("input"));
    await later();
    document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "c", bubbles: true}));
    await later();
    note("coloured", differ());
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

TEST_CASE("a page of one run, and of two side by side, works in a browser", "[report]") {
    const std::string program = report::browser();
    if (program.empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const int runs = GENERATE(1, 2);
    const scene::Folder folder("page");
    std::vector<fs::path> folders;
    std::string at_start, at_end;  // readings of the first chart, run by run
    for (int run = 0; run < runs; ++run) {
        folders.push_back(folder.path / std::to_string(run));
        const std::vector<double> pressure = test::write_results(folders.back(), 0.2 + 0.1 * run);
        for (std::string* readings : {&at_start, &at_end})
            if (run > 0) readings->append(", ");
        at_start += shown(static_cast<float>(pressure.front()));
        at_end += shown(static_cast<float>(pressure.back()));
    }
    std::string page = report::page(folders);
    page.replace(page.rfind("</body>"), 0, VISITOR);
    std::ofstream(folder.path / "page.html") << page;
    const std::string dom = test::printed_by(
        report::dump_command(program, folder.path / "page.html", folder.path / "profile"));
    CHECK(test::seen(dom, "pictures") == std::to_string(runs));
    CHECK(std::stod(test::seen(dom, "ink")) > 0.005);
    CHECK(test::seen(dom, "moved") == "true");
    CHECK(test::seen(dom, "back") == "true");
    CHECK(test::seen(dom, "cut") == "true");
    CHECK(test::seen(dom, "coloured") == "true");
    CHECK(test::seen(dom, "requests") == "0");
    CHECK(test::seen(dom, "start") == "airbag/7/pressure: " + at_start + " GPa");
    CHECK(test::seen(dom, "end") == "airbag/7/pressure: " + at_end + " GPa");
    CHECK(test::seen(dom, "home") == test::seen(dom, "start"));
    CHECK(test::seen(dom, "clock") == "t = 4.5 ms");
}
