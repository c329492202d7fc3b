// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: every recipe in models/recipes folds, and never crosses itself.
#include <catch2/catch.hpp>

#include <filesystem>

#include "tools/fold/fold.hpp"
#include "tools/fold/inspect.hpp"

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
