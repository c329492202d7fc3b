// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <vector>

#include "solver/base/vec.hpp"
#include "tools/fold/pattern/bag.hpp"
#include "tools/new_deck.hpp"

namespace corpuscle::tools {

/// What a folding recipe says of the bag that a starting deck is about.
struct RecipeBag {
    Vec3 inflator;          ///< where the gas comes in                                     [mm]
    std::vector<int> held;  ///< nodes round it that stand still; none where the recipe has an
                            ///< inflator's place or clamps of its own
    int tethers = 0;        ///< their part; 0: none
    bool has_vents = false;
    bool has_module = false;  ///< node set 1: the inflator's place
    bool has_clamps = false;  ///< node set 3
};

/// Folds by a recipe and writes the folded mesh. Throws InputError for a recipe at fault and for
/// folds that cross.
[[nodiscard]] RecipeBag bag_of_recipe(const std::filesystem::path& recipe,
                                      const std::filesystem::path& mesh);

/// Where the gas of a bag that was folded comes in, and what stands still.
[[nodiscard]] RecipeBag starting_bag(const fold::Recipe& recipe, const fold::Bag& bag);

/// Puts into a deck what the recipe says.
void take_recipe(const RecipeBag& folded, NewDeck& deck);

}  // namespace corpuscle::tools
