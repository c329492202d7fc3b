// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a study's page works in a real browser: its table sorts by the column that is clicked, and
// every response is drawn over every factor. Without Chromium this says that it was skipped.

#include <catch2/catch.hpp>

#include <fstream>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"
#include "tools/report/pictures.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// Clicks on the heading of the first response, twice, and looks into the plots.
constexpr const char* VISITOR = R"(<pre id="seen"></pre><script>
(async () => {
    while (!document.body.dataset.ready) await new Promise((go) => setTimeout(go, 50));
    const seen = [], note = (name, value) => seen.push(`${name}=${value};`);
    const column = (k) => [...document.querySelectorAll("tbody tr")].map((row) => row.children[k].textContent).join(" ");
    const heading = () => [...document.querySelectorAll("th")].find((th) => th.textContent.startsWith("100.hic15"));
    note("start", column(0));
    heading().click();
    note("up", column(0));
    heading().click();
    note("down", column(0));
    const plots = [...document.querySelectorAll("#effects canvas")];
    note("plots", plots.map((plot) => plot.getAttribute("aria-label")).join(", "));
    const ink = (plot) => {
        const pixels = plot.getContext("2d").getImageData(0, 0, plot.width, plot.height).data;
        let blue = 0;  // the points
        for (let k = 0; k < pixels.length; k += 4) blue += pixels[k] === 23 && pixels[k + 1] === 105 && pixels[k + 2] === 194;
        return blue;
    };
    note("inked", plots.every((plot) => ink(plot) >= 3 * 16));
    note("requests", performance.getEntriesByType("resource").length);
    document.getElementById("seen").textContent = seen.join("");
})();
</script>)";

}  // namespace

TEST_CASE("a study's page sorts its table and draws its responses over its factors", "[report]") {
    const std::string program = report::browser();
    if (program.empty()) {
        WARN("skipped: there is no Chromium on the PATH");
        return;
    }
    const scene::Folder folder("study_page");
    fs::create_directories(folder.path);
    std::ofstream(folder.path / "study.csv")
        << "run,point,SPEED,NP,seed,status,seconds,100.hic15 [g^2.5 s],100.peak_force [kN],reason\n"
           "1,1,4,100,1,normal,1.5,30,2.5,\n"
           "2,2,6,100,1,normal,1.5,10,2.75,\n"
           "3,3,8,200,1,failed (3),1.5,,,\"the physics broke, at 3\"\n"
           "4,4,8,200,2,normal,1.5,20,1.25,\n";
    std::string page = report::page({folder.path});
    page.replace(page.rfind("</body>"), 0, VISITOR);
    std::ofstream(folder.path / "page.html") << page;
    const std::string dom = test::printed_by(
        report::dump_command(program, folder.path / "page.html", folder.path / "profile"));
    CHECK(test::seen(dom, "start") == "1 2 3 4");
    CHECK(test::seen(dom, "up") == "2 4 1 3");  // what has no value is last
    CHECK(test::seen(dom, "down") == "1 4 2 3");
    CHECK(test::seen(dom, "plots") ==
          "100.hic15 [g^2.5 s] over SPEED, 100.hic15 [g^2.5 s] over NP, "
          "100.peak_force [kN] over SPEED, 100.peak_force [kN] over NP");
    CHECK(test::seen(dom, "inked") == "true");
    CHECK(test::seen(dom, "requests") == "0");
}
