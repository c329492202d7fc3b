// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/commands/new_from_recipe.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "io/system/atomic_file.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/refusal.hpp"

namespace corpuscle::tools {
namespace {

/// Between the panels, over the cloth about the recipe's inflator.
Vec3 middle_of_inflator(const fold::Recipe& recipe, const fold::Bag& bag) {
    Vec3 sum = Vec3::Zero();
    for (const Index n : bag.module) sum += bag.sheet.x[n];
    const double inward = recipe.inflator->is_front ? -0.5 : 0.5;
    return sum / static_cast<double>(bag.module.size()) +
           Vec3(0.0, 0.0, inward * recipe.pattern.gap);
}

/// The middle of a cell, X or x.
Vec3 middle(const fold::Cell& cell, const Points& x) {
    const int corners = fold::corner_count(cell);
    Vec3 sum = Vec3::Zero();
    for (int c = 0; c < corners; ++c) sum += x[cell[c]];
    return sum / corners;
}

/// How far a quad's facets, cut either way, may lie over its middle.
double warp(const fold::Cell& cell, const Points& x, const Vec3& normal) {
    if (fold::corner_count(cell) == 3) return 0.0;
    return 0.25 * std::abs((x[cell[0]] + x[cell[2]] - x[cell[1]] - x[cell[3]]).dot(normal));
}

/// Where the gas of a recipe without an inflator comes in, and the cloth that stands still round it.
struct BackOfBag {
    Vec3 inflator;          ///< between the panels, over the middle of the flat back           [L]
    std::vector<int> held;  ///< nodes of the unfolded back around it, ids of the folded deck
};

/// The cells' normals point inward. Held is what lies as flat as in the pattern, within RADIUS.
BackOfBag middle_of_back(const fold::Recipe& recipe, const fold::Bag& bag) {
    constexpr double RADIUS = 0.15, FLAT = 1e-3;  ///< of a panel's side; of the gap
    const fold::Sheet& sheet = bag.sheet;
    const Points &X = sheet.X, &x = sheet.x;
    const auto is_back = [&](std::size_t c) {
        const fold::BagPart& part = bag.parts[sheet.part[c]];
        return !part.is_front && part.title != "tethers";
    };
    Eigen::AlignedBox3d flat;
    for (const Vec3& at : X) flat.extend(at);
    std::size_t nearest = 0;
    double least = INF;
    for (std::size_t c = 0; c < sheet.cells.size(); ++c) {
        if (!is_back(c)) continue;
        const double away = (middle(sheet.cells[c], X) - flat.center()).norm();
        if (away < least) nearest = c;
        least = std::min(least, away);
    }
    const fold::Cell& cell = sheet.cells[nearest];
    const Vec3 from = middle(cell, x), from_flat = middle(cell, X);
    const Vec3 normal = (x[cell[1]] - x[cell[0]]).cross(x[cell[2]] - x[cell[0]]).normalized();
    const double radius = RADIUS * std::sqrt(0.5 * flat.sizes().x() * flat.sizes().y());
    std::set<int> held;
    for (std::size_t c = 0; c < sheet.cells.size(); ++c)
        for (const Index n : sheet.cells[c]) {
            const double away = (x[n] - from).norm();
            if (is_back(c) && away < radius &&
                std::abs(away - (X[n] - from_flat).norm()) < FLAT * recipe.pattern.gap &&
                std::abs((x[n] - from).dot(normal)) < FLAT * recipe.pattern.gap)
                held.insert(static_cast<int>(n) + 1);
        }
    const double over = 0.5 * recipe.pattern.gap + warp(cell, x, normal);
    return {from + over * normal, {held.begin(), held.end()}};
}

}  // namespace

RecipeBag bag_of_recipe(const std::filesystem::path& from, const std::filesystem::path& mesh) {
    const fold::Recipe recipe = fold::read_recipe(from.string());
    const fold::Bag bag = fold::fold(recipe);
    const fold::Inspection found = fold::inspect(bag, recipe.pattern.gap);
    fold::refuse_crossings(recipe, bag, found, mesh);
    io::replace_text(mesh, fold::bag_deck(bag, recipe, found));
    fmt::print("{}\n", fold::text(found));
    return starting_bag(recipe, bag);
}

RecipeBag starting_bag(const fold::Recipe& recipe, const fold::Bag& bag) {
    RecipeBag folded;
    folded.has_vents = bag.has_vents;
    folded.has_module = !bag.module.empty();
    folded.has_clamps = !bag.clamped.empty();
    if (!recipe.tethers.empty()) folded.tethers = recipe.parts.tether;
    if (recipe.inflator) {
        folded.inflator = middle_of_inflator(recipe, bag);
        return folded;
    }
    BackOfBag back = middle_of_back(recipe, bag);
    folded.inflator = back.inflator;
    if (!folded.has_module && !folded.has_clamps) folded.held = std::move(back.held);
    return folded;
}

void take_recipe(const RecipeBag& folded, NewDeck& deck) {
    deck.inflator = folded.inflator;
    deck.held = folded.held;
    deck.has_part_set = true;
    deck.whole = 1;
    deck.has_vents = folded.has_vents;
    deck.has_module = folded.has_module;
    deck.has_clamps = folded.has_clamps;
    deck.tethers = folded.tethers;
}

}  // namespace corpuscle::tools
