// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "tools/fold/inspect/inspect.hpp"

namespace corpuscle::fold {

/// A pack with crossings is no bag's deck: its mesh is written as OUT.refused.k, to be looked at,
/// and its section beside it; then the recipe is folded anew with other gaps and elements, until
/// one is found that does not cross, so that what the message advises is true.
/// @param output  where the deck would have gone
/// @throws InputError  with the pairs of shells and what helps; nothing happens without crossings
void refuse_crossings(const Recipe& recipe, const Bag& bag, const Inspection& found,
                      const std::filesystem::path& output);

}  // namespace corpuscle::fold
