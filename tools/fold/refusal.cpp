// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/refusal.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/system/atomic_file.hpp"
#include "solver/base/error.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"

namespace corpuscle::fold {
namespace {

constexpr std::size_t SHOWN_CROSSINGS = 10;

/// What is tried, in this order: factors on the gap and on the element.
constexpr std::array<std::pair<double, double>, 5> TRIED{
    {{0.7, 1.0}, {1.0, 0.7}, {1.4, 1.0}, {0.5, 1.0}, {1.0, 1.4}}};

/// Does the recipe fold without crossings, with its gap and element changed?
bool folds(Recipe recipe, double gap, double element) {
    const bool closes_by_default = recipe.pattern.closing == 1.5 * recipe.pattern.element;
    const bool bends_by_default = recipe.pattern.band == recipe.pattern.element;
    recipe.pattern.gap *= gap;
    recipe.pattern.element *= element;
    if (closes_by_default) recipe.pattern.closing = 1.5 * recipe.pattern.element;
    if (bends_by_default) recipe.pattern.band = recipe.pattern.element;
    try {
        return crossing_cells(fold(recipe).sheet).empty();
    } catch (const InputError&) {
        return false;
    }
}

std::string advice(const Recipe& recipe) {
    const bool is_mesh_given = recipe.pattern.kind == PatternKind::DECK;
    for (const auto& [gap, element] : TRIED) {
        if (is_mesh_given && element != 1.0) continue;
        if (folds(recipe, gap, element))
            return gap != 1.0 ? fmt::format("it folds without crossings with gap = {:.4g}",
                                            gap * recipe.pattern.gap)
                              : fmt::format("it folds without crossings with element = {:.4g}",
                                            element * recipe.pattern.element);
    }
    return fmt::format(
        "gaps of {:.4g} to {:.4g}{} were tried and cross too: change the places of the folds",
        0.5 * recipe.pattern.gap, 1.4 * recipe.pattern.gap,
        is_mesh_given ? ""
                      : fmt::format(" and elements of {:.4g} to {:.4g}",
                                    0.7 * recipe.pattern.element, 1.4 * recipe.pattern.element));
}

}  // namespace

void refuse_crossings(const Recipe& recipe, const Bag& bag, const Inspection& found,
                      const std::filesystem::path& output) {
    if (found.crossings.empty()) return;
    const auto refused = std::filesystem::path(output).replace_extension(".refused.k");
    const auto picture = std::filesystem::path(output).replace_extension(".refused.svg");
    io::replace_text(refused, bag_deck(bag, recipe, found));
    io::replace_text(picture, section_svg(bag, found));
    std::vector<std::string> faults{fmt::format(
        "{}: {} pairs of shells cross when folded; the mesh is in {}, its section in {}; {}",
        recipe.file, found.crossings.size(), refused.string(), picture.string(), advice(recipe))};
    for (std::size_t i = 0; i < std::min(SHOWN_CROSSINGS, found.crossings.size()); ++i)
        faults.push_back(fmt::format("{}: shells {} and {} cross", recipe.file,
                                     found.crossings[i].first + 1, found.crossings[i].second + 1));
    throw InputError(faults);
}

}  // namespace corpuscle::fold
