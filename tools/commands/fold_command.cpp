// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT

#include <fmt/core.h>

#include <filesystem>

#include "io/system/atomic_file.hpp"
#include "tools/commands/commands.hpp"
#include "tools/fold/bag_deck.hpp"
#include "tools/fold/fold.hpp"
#include "tools/fold/refusal.hpp"

namespace corpuscle::tools {
int fold(const FoldArguments& arguments) {
    const fold::Recipe recipe = fold::read_recipe(arguments.recipe);
    const auto picture = std::filesystem::path(arguments.output).replace_extension(".svg");
    for (const std::filesystem::path& output : {std::filesystem::path(arguments.output), picture})
        expect_no_input(output, {arguments.recipe, recipe.pattern.deck});
    const fold::Bag bag = fold::fold(recipe);
    const fold::Inspection found = fold::inspect(bag, recipe.pattern.gap);
    fold::refuse_crossings(recipe, bag, found, arguments.output);
    io::replace_text(arguments.output, fold::bag_deck(bag, recipe, found));
    io::replace_text(picture, fold::section_svg(bag, found));
    fmt::print("{}\n", fold::text(found));
    for (const std::string& remark : bag.remarks) fmt::print("note: {}\n", remark);
    if (recipe.package) fmt::print("{}\n", fold::fit(found, *recipe.package));
    fmt::print("{}: {} nodes, {} shells; section: {}\n", arguments.output, bag.sheet.x.size(),
               bag.sheet.cells.size(), picture.string());
    return 0;
}

}  // namespace corpuscle::tools
