// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: folding never makes cloth cross itself, whatever is folded; counted exactly.
#include <catch2/catch.hpp>

#include <map>
#include <numbers>

#include "solver/base/error.hpp"
#include "tests/support/random/random_recipe.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/inspect/inspect.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

constexpr int WANTED = 24;

/// Of both panels, as drawn.
double pattern_area(const Recipe& r) {
    const Pattern& p = r.pattern;
    return p.kind == PatternKind::DISC ? 0.5 * std::numbers::pi * p.diameter * p.diameter
                                       : 2.0 * p.length * p.width;
}

double panel_area(const Bag& bag) {
    double sum = 0.0;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e)
        if (bag.parts[bag.sheet.part[e]].title != "tethers")
            sum += area(bag.sheet.cells[e], bag.sheet.X);
    return sum;
}

/// Edges of the closed surface at which not two facets meet; quads are cut from their first corner.
int wrong_edges(const Bag& bag) {
    std::map<std::pair<Index, Index>, int> facets;
    const auto add = [&](Index a, Index b, Index c) {
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
            ++facets[{std::min(p, q), std::max(p, q)}];
    };
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        const Cell& c = bag.sheet.cells[e];
        if (bag.parts[bag.sheet.part[e]].title == "tethers") continue;
        add(c[0], c[1], c[2]);
        if (corner_count(c) == 4) add(c[0], c[2], c[3]);
    }
    return static_cast<int>(std::count_if(facets.begin(), facets.end(),
                                          [](const auto& edge) { return edge.second != 2; }));
}

/// The recipe folded, or nothing if one of its lines has no cloth on both sides, or too little for
/// a pack so thick: a recipe that is refused says so.
std::optional<Bag> fold_or_refuse(const Recipe& recipe) {
    try {
        return fold::fold(recipe);
    } catch (const InputError& error) {
        const std::string what = error.what();
        CHECK((what.find("where there is cloth") != std::string::npos ||
               what.find("make the pleats wider") != std::string::npos ||
               what.find("make it less deep") != std::string::npos));
        return std::nullopt;
    }
}

/// Folds recipes until WANTED are folded without a crossing.
/// @param random_text  recipe of a seed
/// @param stretch  that an edge may have at most
/// @param spared   packs that may cross, and are thus refused by the command
template <class Text>
void fold_many(unsigned first_seed, const Text& random_text, double stretch, int spared) {
    int folded = 0, crossed = 0;
    for (unsigned seed = first_seed; folded < WANTED; ++seed) {
        REQUIRE(seed < first_seed + 2 * WANTED);  // most must fold
        const std::string text = random_text(seed);
        INFO("seed " << seed << "\n" << text);
        const Recipe recipe = parse_recipe(text, "random.toml");
        const auto bag = fold_or_refuse(recipe);
        if (!bag) continue;
        const Inspection found = inspect(*bag, 0.0);
        if (!found.crossings.empty()) {
            CHECK(++crossed <= spared);
            continue;
        }
        ++folded;
        CHECK(found.layers >= 4);
        CHECK(wrong_edges(*bag) == 0);
        CHECK(found.least_angle > 0.0);
        CHECK(found.greatest_strain < stretch);
        CHECK(found.least_strain > -0.9);
        if (recipe.hole && recipe.hole->depth > 0.0) continue;  // a dish has more
        // the rim is a polygon, and gives way by up to 0.2 of an element here and there
        const double size = recipe.pattern.element;
        const double rim = 4.0 * std::sqrt(pattern_area(recipe));
        CHECK(panel_area(*bag) == Approx(pattern_area(recipe)).margin(0.02 * size * rim));
    }
}

}  // namespace

TEST_CASE("random recipes along the axes fold without a crossing", "[fold]") {
    fold_many(
        1, [](unsigned seed) { return support::random_recipe(seed, false); }, 0.08, 0);
}

TEST_CASE("random recipes in any direction fold without a crossing, but for one in twenty",
          "[fold]") {
    fold_many(
        101, [](unsigned seed) { return support::random_recipe(seed, true); }, 0.08, 1);
}

TEST_CASE("random tucks with a fold across them do not cross but for one in twenty", "[fold]") {
    fold_many(201, support::random_tuck_recipe, 0.08, 1);
}

TEST_CASE("random airbags with a dish, which are deployed elsewhere, do not cross but for one",
          "[fold]") {
    // 0.13: a needle where borders of two oblique folds cross a corner
    fold_many(1, support::random_airbag_recipe, 0.15, 1);
}
