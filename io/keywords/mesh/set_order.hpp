// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "io/keywords/tasks.hpp"

namespace corpuscle::io::keywords {

/// Sets of sets (_ADD, _INTERSECT, _GENERAL) each after those that it is made of, wherever they
/// stand in the deck. Circles are faults; what is of one is left out.
///
/// @param tasks  by phase
void order_sets(std::vector<Task>& tasks, const Parameters& parameters, Faults& faults,
                DraftNames& names);

}  // namespace corpuscle::io::keywords
