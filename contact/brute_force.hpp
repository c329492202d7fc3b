// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/box.hpp"

/// The plain way, kept as the oracle that the quick one is held to.
namespace corpuscle::contact::brute_force {

/// All overlapping pairs i < j, sorted.
[[nodiscard]] std::vector<std::pair<Index, Index>> self_pairs(std::span<const Box> boxes);

/// All overlapping pairs (row in a, row in b), sorted.
[[nodiscard]] std::vector<std::pair<Index, Index>> pairs(std::span<const Box> a,
                                                         std::span<const Box> b);

}  // namespace corpuscle::contact::brute_force
