// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <fstream>
#include <sstream>

#include "solver/base/error.hpp"
#include "tests/unit/io/results/results_scene.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/refusal.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

const std::string HALVED_DISC =
    "[pattern]\nkind = \"disc\"\ndiameter = 300\nelement = 15\ngap = 1.0\n"
    "[[fold]]\nkind = \"half\"\nat = 40\n";
const std::string INFLATOR = "[inflator]\nat = [-20.0, 10.0]\ndiameter = 80\n";
const std::string CLAMP =
    "[[clamp]]\nat = [0, -100]\ndiameter = 50\npanel = \"front\"\n"
    "[[clamp]]\nat = [0, 100]\ndiameter = 50\npanel = \"front\"\n";

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

}  // namespace

TEST_CASE("nodes about the inflator and under clamps are sets of the deck", "[fold]") {
    const Recipe recipe = parse_recipe(HALVED_DISC + INFLATOR + CLAMP, "bag.toml");
    const Bag bag = fold::fold(recipe);
    CHECK(bag.module.size() > 10);  // of some 22 nodes in a circle of 80
    for (const Index n : bag.module) {
        CHECK(std::hypot(bag.sheet.X[n].x() + 20.0, bag.sheet.X[n].y() - 10.0) <= 40.0);
        CHECK(bag.sheet.x[n].z() < 0.0);  // of the back
    }
    CHECK(bag.clamped.size() > 8);
    for (const Index n : bag.clamped) {
        CHECK(std::hypot(bag.sheet.X[n].x(), std::abs(bag.sheet.X[n].y()) - 100.0) <= 25.0);
        CHECK(bag.sheet.x[n].z() > 0.0);
    }
    const std::string deck = bag_deck(bag, recipe, inspect(bag, 1.0));
    CHECK(deck.find("module: cloth about the inflator\n         1\n") != std::string::npos);
    CHECK(deck.find("clamped\n         3\n") != std::string::npos);
}

TEST_CASE("a spot without nodes is a fault with its line and what would do", "[fold]") {
    const Recipe recipe = parse_recipe(
        HALVED_DISC + "[[clamp]]\nat = [400, 0]\ndiameter = 50\npanel = \"back\"\n", "bag.toml");
    CHECK_THROWS_WITH(fold::fold(recipe),
                      Catch::StartsWith("bag.toml:9: [[clamp]] of diameter 50 at (400, 0) holds no "
                                        "node of the back panel: the nearest is 249.8 away"));
    CHECK_THROWS_WITH(parse_recipe(HALVED_DISC + INFLATOR + "[hole]\ndiameter = 60\n", "bag.toml"),
                      Catch::Contains("the [hole]'s cover is the inflator's place"));
}

TEST_CASE("a refused fold leaves its mesh, and its advice was tried", "[fold]") {
    const scene::Folder folder("refused");
    std::filesystem::create_directories(folder.path);
    const Recipe recipe = parse_recipe(HALVED_DISC, "bag.toml");
    const Bag bag = fold::fold(recipe);
    Inspection found = inspect(bag, 1.0);
    REQUIRE_NOTHROW(refuse_crossings(recipe, bag, found, folder.path / "out.k"));
    CHECK(std::filesystem::is_empty(folder.path));
    found.crossings = {{3, 7}};  // as if
    CHECK_THROWS_WITH(refuse_crossings(recipe, bag, found, folder.path / "out.k"),
                      Catch::Contains("out.refused.k") &&
                          Catch::Contains("it folds without crossings with gap = 0.7"));
    CHECK(text_of(folder.path / "out.refused.k").find("*ELEMENT_SHELL") != std::string::npos);
    CHECK(std::filesystem::exists(folder.path / "out.refused.svg"));
    CHECK_FALSE(std::filesystem::exists(folder.path / "out.k"));
}
