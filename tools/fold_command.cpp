// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>

#include "io/atomic_file.hpp"
#include "solver/base/error.hpp"
#include "tools/commands.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"

namespace corpuscle::tools {
namespace {

constexpr std::size_t SHOWN_CROSSINGS = 10;

/// A pack with crossings is never written.
void refuse_crossings(const fold::Recipe& recipe, const fold::Inspection& found) {
    if (found.crossings.empty()) return;
    std::vector<std::string> faults{
        fmt::format("{}: {} pairs of shells cross when folded; nothing was written. A greater gap, "
                    "wider pleats "
                    "or smaller elements help",
                    recipe.file, found.crossings.size())};
    for (std::size_t i = 0; i < std::min(SHOWN_CROSSINGS, found.crossings.size()); ++i)
        faults.push_back(fmt::format("{}: shells {} and {} cross", recipe.file,
                                     found.crossings[i].first + 1, found.crossings[i].second + 1));
    throw InputError(faults);
}

}  // namespace

int fold(const FoldArguments& arguments) {
    const fold::Recipe recipe = fold::read_recipe(arguments.recipe);
    const fold::Bag bag = fold::fold(recipe);
    const fold::Inspection found = fold::inspect(bag, recipe.pattern.gap);
    refuse_crossings(recipe, found);
    const auto picture = std::filesystem::path(arguments.output).replace_extension(".svg");
    io::replace_text(arguments.output, fold::bag_deck(bag, recipe, found));
    io::replace_text(picture, fold::section_svg(bag, found));
    fmt::print("{}\n", fold::text(found));
    if (recipe.package) fmt::print("{}\n", fold::fit(found, *recipe.package));
    fmt::print("{}: {} nodes, {} shells; section: {}\n", arguments.output, bag.sheet.x.size(),
               bag.sheet.cells.size(), picture.string());
    return 0;
}

}  // namespace corpuscle::tools
