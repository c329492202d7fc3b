// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the page of a run, or of two, works in a real browser: the pictures are not blank, grow
// and are cut as the bag is, the slider moves bag and cursor together, the curves hold the runs'
// numbers, keys and mouse do what they should, and no request leaves the file. Without Chromium and
// its driver this says that it was skipped.

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// As the page shows a number: five digits.
std::string shown(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.5g", static_cast<double>(static_cast<float>(value)));
    const double rounded = std::stod(text.data());
    if (std::abs(rounded) >= 1e5)  // a browser writes large numbers without an exponent
        std::snprintf(text.data(), text.size(), "%.0f", rounded);
    return text.data();
}

}  // namespace

TEST_CASE("a page of one run, and of two side by side, works in a browser", "[report]") {
    if (!test::Visit::is_possible()) return;
    const int runs = GENERATE(1, 2);
    const scene::Folder folder("page");
    std::vector<fs::path> folders;
    std::vector<std::string> words{"0,1.5,3,4.5"};
    std::string at_start, at_end, points;  // readings of the first chart, run by run
    for (int run = 0; run < runs; ++run) {
        folders.push_back(folder.path / std::to_string(run));
        const std::vector<double> pressure = test::write_results(folders.back(), 0.2 + 0.1 * run);
        std::string& list = words.emplace_back();
        for (const double value : pressure) list += std::to_string(1e6 * value) + ",";  // GPa
        list.pop_back();
        for (std::string* readings : {&at_start, &at_end, &points})
            if (run > 0) *readings += readings == &points ? "," : ", ";
        at_start += shown(1e6 * pressure.front());
        at_end += shown(1e6 * pressure.back());
        points += "4";
    }
    const test::Visit seen("visit_run.mjs", report::page(folders), words, folder.path);
    CHECK(seen["pictures"] == std::to_string(runs));
    CHECK(std::stod(seen["ink"]) > 0.005);
    CHECK(std::stoi(seen["colours"]) > 4);  // two lit parts and the gas
    CHECK(seen["start"] == "bag 7: pressure: " + at_start + " kPa");
    CHECK(seen["curve"] == "[" + points + "]");

    CHECK(seen["bag grows"] == "true");
    // in one scale: the second run's bag ends 1.9 / 1.6 times as large
    CHECK(std::stod(seen["last over first bag"]) == Approx(runs == 1 ? 1.0 : 1.19).epsilon(0.1));
    CHECK(std::stod(seen["cursor off"]) < 0.01);
    CHECK(seen["end"] == "bag 7: pressure: " + at_end + " kPa");
    CHECK(seen["legend"] == "4.5, " + at_end);
    CHECK(seen["clock"] == "t = 4.5 ms");

    const std::string volume = "0.0030141";  // the scene's at the last time
    CHECK(seen["chosen"] ==
          "bag 7: volume: " + (runs == 1 ? volume : volume + ", " + volume) + " l");
    CHECK(std::stod(seen["cursor of chosen off"]) < 0.01);

    CHECK(seen["home"] == seen["start"]);
    CHECK(seen["back"] == "true");
    CHECK(seen["right"] == "1.5");
    CHECK(seen["left"] == "0");
    CHECK(seen["end key"] == "4.5");
    for (const char* key : {"colour", "dots", "view"}) {
        INFO(key);
        CHECK(seen[key] == "true");
    }
    CHECK(seen["gas"] == "true");
    CHECK(seen["plays"] == "pause");
    CHECK(seen["played"] == "play");

    CHECK(seen["cuts"] ==
          R"({"x":true,"-x":true,"y":true,"-y":true,"z":true,"-z":true})");  // and back
    CHECK(seen["turned"] == "true");
    CHECK(seen["smaller"] == "true");
    CHECK(seen["picked"] == "true");
    CHECK(seen["zoomed"] == "true");
    CHECK(seen["time kept"] == "true");
    CHECK(seen["fits"] == "true");
    CHECK(seen["idle"] == "true");
    for (const char* what : {"hidden", "shown", "up", "up again", "projector"}) {
        INFO(what);
        CHECK(seen[what] == "true");
    }
    CHECK(seen["opens at"] == "4.5");  // the body's force grows to the end
    CHECK(seen["requests"] == "[]");
    CHECK(seen["faults"] == "[]");
}
