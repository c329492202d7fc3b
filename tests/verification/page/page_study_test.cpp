// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a study's page works in a real browser: its table sorts by the column that is clicked, and
// every response is drawn over every factor, with its means. Without Chromium and its driver
// this says that it was skipped.

#include <catch2/catch.hpp>

#include <fstream>

#include "tests/support/page_visit.hpp"
#include "tools/report/page.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

TEST_CASE("a study's page sorts its table and draws its responses over its factors", "[report]") {
    if (!test::Visit::is_possible()) return;
    const scene::Folder folder("study_page");
    fs::create_directories(folder.path);
    std::ofstream(folder.path / "study.csv")
        << "run,point,SPEED,NP,seed,status,seconds,100.hic15 [g^2.5 s],100.peak_force [kN],reason\n"
           "1,1,4,100,1,normal,1.5,30,2.5,\n"
           "2,2,6,100,1,normal,1.5,10,2.75,\n"
           "3,3,8,200,1,failed (3),1.5,,,\"the physics broke, at 3\"\n"
           "4,4,8,200,2,normal,1.5,20,1.25,\n";
    const test::Visit seen("visit_study.mjs", report::page({folder.path}),
                           {"100.hic15", "4,30 6,10 8,20", "100,30 100,10 200,20",
                            "4,2.5 6,2.75 8,1.25", "100,2.5 100,2.75 200,1.25"},
                           folder.path);
    CHECK(seen["start"] == "1 2 3 4");
    CHECK(seen["up"] == "2 4 1 3");  // what has no value is last
    CHECK(seen["down"] == "1 4 2 3");
    CHECK(seen["plots"] ==
          "100.hic15 [g^2.5 s] over SPEED, 100.hic15 [g^2.5 s] over NP, "
          "100.peak_force [kN] over SPEED, 100.peak_force [kN] over NP");
    CHECK(seen["points"] == "[3,3,3,3]");
    CHECK(seen["means"] == "[0,1,0,1]");  // where there are several runs
    CHECK(seen["requests"] == "[]");
    CHECK(seen["faults"] == "[]");
}
