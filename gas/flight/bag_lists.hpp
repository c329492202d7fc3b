// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/flight/facet_lists.hpp"

namespace corpuscle::gas {

/// Builds facet lists over a whole bag in cells of the wanted edge: neither finer than a hundredth
/// of the bag, which only costs, nor coarser than a quarter of it.
void build_over_bag(FacetLists& lists, double edge, double margin, double reach, const Points& x_0,
                    const Points& x_1);

/// The same over the bag at x, in cells that fit it: particles beyond the outermost belong to them.
void build_fitted_to_bag(FacetLists& lists, double edge, double margin, const Points& x);

/// The displacement from x_0 to x_1 as a multiple of the bag's size.
[[nodiscard]] double displacement_over_size(const FacetLists& lists, const Points& x_0,
                                            const Points& x_1);

}  // namespace corpuscle::gas
