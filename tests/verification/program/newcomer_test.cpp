// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: from an STL of a flat disc to a deployed bag with a headform and a study takes four
// commands and no script.

#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "tests/places.hpp"
#include "tests/unit/io/deck/deck_scene.hpp"

using namespace corpuscle;
namespace fs = std::filesystem;

namespace {

/// A disc of 300 mm in triangles, as a CAD program writes it.
std::string disc() {
    constexpr int RINGS = 6, ROUND = 24;
    std::ostringstream stl;
    stl << "solid disc\n";
    const auto at = [](int ring, int k) {
        const double r = 150.0 * ring / RINGS, a = 2.0 * M_PI * k / ROUND;
        return Vec3(r * std::cos(a), r * std::sin(a), 0.0);
    };
    const auto facet = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        stl << "facet normal 0 0 1\nouter loop\n";
        for (const Vec3& v : {a, b, c})
            stl << "vertex " << v.x() << ' ' << v.y() << ' ' << v.z() << '\n';
        stl << "endloop\nendfacet\n";
    };
    for (int k = 0; k < ROUND; ++k) {
        facet(at(0, 0), at(1, k), at(1, (k + 1) % ROUND));
        for (int ring = 1; ring < RINGS; ++ring) {
            const Vec3 a = at(ring, k), b = at(ring + 1, k), c = at(ring + 1, (k + 1) % ROUND),
                       d = at(ring, (k + 1) % ROUND);
            facet(a, b, c);
            facet(a, c, d);
        }
    }
    stl << "endsolid disc\n";
    return stl.str();
}

/// What the program says; it must end well.
std::string said(const std::string& arguments) {
    const std::string command = CORPUSCLE_PROGRAM " " + arguments + " 2>&1";
    CAPTURE(command);
    FILE* const pipe = popen(command.c_str(), "r");
    REQUIRE(pipe != nullptr);
    std::string text;
    std::array<char, 4096> part;
    while (std::fgets(part.data(), part.size(), pipe) != nullptr) text += part.data();
    CAPTURE(text);
    CHECK(pclose(pipe) == 0);
    return text;
}

}  // namespace

TEST_CASE("from an STL to a table of a study in four commands", "[new]") {
    using Catch::Contains;
    const test::DeckFolder folder;
    const std::string stl = folder.write("disc.stl", disc()).string();
    const fs::path here = fs::path(stl).parent_path();
    const std::string deck = (here / "bag.k").string();

    CHECK_THAT(said("new --from '" + stl + "' --head -o '" + deck + "'"),
               Contains("a second panel is sewn to its rim"));
    const std::string checked = said("check '" + deck + "'");
    CHECK_THAT(checked, Contains("gauge in that volume") && Contains("units: kg-mm-ms-K"));
    CHECK_THAT(checked, !Contains("expected"));

    const std::string run = said("run '" + deck + "' -D NP=2000 --until 6");
    CHECK_THAT(run, Contains("normal termination at t = 6 ms") && Contains("kPa gauge"));

    // the study of the same bag, shorter
    const fs::path study = here / "bag.study.toml";
    std::ostringstream text;
    text << std::ifstream(study).rdbuf();
    folder.write("short.toml", "until = 3.0\n" + text.str() + "[fixed]\nNP = 2000\n");
    said("study '" + (here / "short.toml").string() + "' -o '" + (here / "out").string() + "'");
    std::ifstream table(here / "out" / "study.csv");
    std::string line;
    int rows = 0;
    while (std::getline(table, line)) ++rows;
    CHECK(rows == 3);  // the head and two speeds
}

TEST_CASE("folded bags and meshes become decks that are accepted", "[new]") {
    const test::DeckFolder folder;
    const fs::path models = CORPUSCLE_MODELS;
    const std::string deck = (folder.write("note", "").parent_path() / "bag.k").string();
    for (const char* from : {"recipes/zigzag.toml", "recipes/half.toml", "recipes/rectangle.toml",
                             "driver_bag_flat/mesh.k"}) {
        said("new --from '" + (models / from).string() + "' -o '" + deck + "'");
        CHECK_THAT(said("check '" + deck + "'"), Catch::Contains("units: kg-mm-ms-K"));
    }
}

TEST_CASE("a folded deck becomes a deck that is accepted, with a head too", "[new]") {
    const test::DeckFolder folder;
    const fs::path models = CORPUSCLE_MODELS, here = folder.write("note", "").parent_path();
    const std::string folded = (here / "folded.k").string(), deck = (here / "bag.k").string();
    for (const char* from : {"recipes/zigzag.toml", "recipes/rectangle.toml"})
        for (const char* head : {"", " --head"}) {
            said("fold '" + (models / from).string() + "' -o '" + folded + "'");
            said("new --from '" + folded + "' -o '" + deck + "'" + head);
            CHECK_THAT(said("check '" + deck + "'"), Catch::Contains("units: kg-mm-ms-K"));
        }
}
