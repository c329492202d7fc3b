// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/recipe/recipe.hpp"

#include <catch2/catch.hpp>

#include "solver/base/error.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

const std::string PATTERN = "[pattern]\nkind = \"disc\"\ndiameter = 700\nelement = 12\ngap = 0.7\n";

std::vector<std::string> faults(const std::string& text) {
    try {
        (void)parse_recipe(text, "bag.toml");
    } catch (const InputError& error) {
        return error.faults;
    }
    return {};
}

}  // namespace

TEST_CASE("a recipe's zigzag has its lines where the pleats end", "[fold]") {
    const Recipe r = parse_recipe(PATTERN +
                                      "[[fold]]\nkind = \"zigzag\"\nangle = 90\nside = "
                                      "\"both\"\nstart = 70\npleats = [60, 50]\n",
                                  "bag.toml");
    REQUIRE(r.steps.size() == 1);
    REQUIRE(r.steps[0].moves.size() == 2);
    CHECK(std::get<Accordion>(r.steps[0].moves[0]).lines == std::vector{70.0, 130.0, 180.0});
    CHECK_FALSE(std::get<Accordion>(r.steps[0].moves[0]).is_left);
    CHECK(std::get<Accordion>(r.steps[0].moves[1]).is_left);
}

TEST_CASE("a roll is a half fold after the other, each further in", "[fold]") {
    const Recipe r = parse_recipe(
        PATTERN +
            "[[fold]]\nkind = \"roll\"\nonto = \"back\"\nstart = 300\nwidth = 40\ncount = 3\n",
        "bag.toml");
    REQUIRE(r.steps[0].moves.size() == 3);
    CHECK(std::get<Accordion>(r.steps[0].moves[2]).lines == std::vector{220.0});
    CHECK(std::get<Accordion>(r.steps[0].moves[2]).is_down);
}

TEST_CASE("every fault of a recipe is told with its line", "[fold]") {
    const auto found = faults(
        "[pattern]\nkind = \"disc\"\ndiameter = -3\nelement = 12\ngap = 0.7\nradious = 4\n"
        "[[fold]]\nkind = \"zigzag\"\nwidth = 0\n[[vent]]\nat = [1]\ndiameter = 30\n[sauce]\n");
    REQUIRE(found.size() == 5);
    CHECK(found[0] == "bag.toml:3: [pattern] diameter = -3, expected a positive number");
    CHECK(found[1] == "bag.toml:6: [pattern] has no key radious");
    CHECK(found[2] == "bag.toml:11: [[vent]] at = [ 1 ], expected a list of 2 numbers");
    CHECK(found[3] == "bag.toml:9: [[fold]] width = 0, expected a positive number");
    CHECK(found[4] == "bag.toml:13: the recipe has no key sauce");
}

TEST_CASE("a misspelt key gets the nearest name, and a broken file its line", "[fold]") {
    CHECK(faults("[pattern]\nkind = \"disc\"\ndiametre = 700\nelement = 12\ngap = 0.7\n").size() ==
          2);
    CHECK(faults(PATTERN + "[[fold]]\nkind = \"zigzag\"\nwidht = 3\nwidth = 60\n") ==
          std::vector<std::string>{"bag.toml:8: [[fold]] has no key widht, did you mean width?"});
    const auto found = faults("[pattern]\nkind = \n");
    REQUIRE(found.size() == 1);
    CHECK(found[0].rfind("bag.toml:2: ", 0) == 0);
}

TEST_CASE("values of another kind are faults, not numbers", "[fold]") {
    CHECK(faults("[pattern]\nkind = \"disc\"\ndiameter = \"big\"\nelement = true\ngap = inf\n")
              .size() == 3);
    CHECK(faults(PATTERN + "[hole]\ndiameter = 90\nreinforcement = 80\n").size() == 1);
    CHECK(faults(PATTERN + "[[tether]]\nfrom = [0, 0]\ndirection = 45\nlength = 10\nwidth = 5\n")
              .size() == 1);
    CHECK(faults(PATTERN + "[[fold]]\nkind = \"crumple\"\n").size() == 1);
    CHECK(faults(PATTERN + "[[fold]]\nkind = \"tuck\"\n").size() == 1);  // nowhere
    CHECK(faults("[pattern]\nkind = \"star\"\nelement = 12\ngap = 0.7\n").size() == 2);
    CHECK(faults(PATTERN + "fold = 3\n").size() == 1);
}

TEST_CASE("elements that are too small for the machine are refused before they are made",
          "[fold]") {
    const auto of = [](const std::string& pattern) {
        return faults("[pattern]\n" + pattern + "\ngap = 0.7\n");
    };
    const auto disc = of("kind = \"disc\"\ndiameter = 600\nelement = 0.01");
    REQUIRE(disc.size() == 1);
    CHECK(disc[0] ==
          "bag.toml:4: [pattern] element = 0.01, expected 0.752 or more, for 1000000 cells in all "
          "at most");
    CHECK(of("kind = \"rectangle\"\nlength = 1000\nwidth = 500\nelement = 0.99").size() == 1);
    CHECK(of("kind = \"rectangle\"\nlength = 1000\nwidth = 500\nelement = 1.01").empty());
}
