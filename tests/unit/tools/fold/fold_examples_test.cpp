// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: every recipe in models/recipes folds, and never crosses itself.
#include <catch2/catch.hpp>

#include <algorithm>
#include <filesystem>
#include <numbers>

#include "tests/places.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/inspect/inspect.hpp"
#include "tools/fold/mesh/improve.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

TEST_CASE("the example recipes fold without a crossing", "[fold]") {
    std::vector<std::filesystem::path> recipes;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(CORPUSCLE_MODELS) / "recipes"))
        if (entry.path().extension() == ".toml") recipes.push_back(entry.path());
    CHECK(recipes.size() >= 8);
    for (const auto& file : recipes) {
        INFO(file.filename().string());
        const Recipe recipe = read_recipe(file);
        const Bag bag = fold::fold(recipe);
        const Inspection found = inspect(bag, 0.0);
        CHECK(found.crossings.empty());
        CHECK(found.layers >= 4);
        CHECK(found.greatest_strain < 0.08);
        if (recipe.package) CHECK(fit(found, *recipe.package).find("fits into") == 0);
    }
}

TEST_CASE("the folded driver bag has no needles, and the areas of its drawing", "[fold]") {
    const Recipe recipe =
        read_recipe(std::filesystem::path(CORPUSCLE_MODELS) / "driver_bag_folded" / "fold.toml");
    const Bag bag = fold::fold(recipe);
    double least = 1e9, vents = 0.0, front = 0.0;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        Points X;
        Cell flat{0, 1, 2, 2};
        const Cell& c = bag.sheet.cells[e];
        for (int k = 0; k < corner_count(c); ++k) X.push_back(bag.sheet.X[c[k]]);
        if (corner_count(c) == 4) flat[3] = 3;
        const BagPart& part = bag.parts[bag.sheet.part[e]];
        if (part.is_front) std::reverse(X.begin(), X.end());  // fold() turns its cells
        if (part.id != recipe.parts.module) least = std::min(least, reach(flat, X));
        if (part.id == recipe.parts.vent) vents += area(c, bag.sheet.X);
        if (part.id == recipe.parts.front) front += area(c, bag.sheet.X);
    }
    CHECK(least > 0.2 * recipe.pattern.element);
    CHECK(front == Approx(0.25 * std::numbers::pi * 720.0 * 720.0).epsilon(1e-3));
    CHECK(vents == Approx(0.5 * std::numbers::pi * 30.0 * 30.0).epsilon(0.02));
}
