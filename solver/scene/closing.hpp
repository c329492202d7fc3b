// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/model.hpp"

namespace corpuscle {

/// Closes the bags of a scene where there is one right way to do it, in this order:
///
///     1. nodes that hang on an edge that is not divided there are tied to its ends
///     2. a part joins the bag when all its free edges are free edges of the bag
///     3. a hole of at most Model::lid_share of the bag's area gets a lid over its rim: a part of
///        its own, without mass, that only the gas feels
///
/// Each is written to Model::mendings, and a lid to the warnings too. Facets that are turned round
/// are the gas's to turn (gas/enclosure), and a mending too.
/// @throws InputError with a description of every hole that is left: its bag, centre, width, edges,
/// area, and the parts that touch its rim; with Model::closes_bags = false of all that there are.
void close_bags(Model& model);

}  // namespace corpuscle
