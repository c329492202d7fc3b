// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gas/cards/opening_cards.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// The fabric of one bag as the gas sees it.
struct BagWalls {
    std::vector<Triangle> triangles;     ///< the closing ones first, then the internal ones
    std::vector<Index> shell;            ///< a shell row a triangle
    std::vector<Index> part;             ///< a row in part_ids a triangle
    std::size_t closing = 0;             ///< how many close the bag
    std::size_t empty_pairs = 0;         ///< left out: closing facets that enclose nothing
    std::vector<int> part_ids;           ///< the deck's numbers of the parts that wall it
    std::vector<Index> part_rows;        ///< the same parts, as rows of the model
    std::vector<LeakCard> leaks;         ///< of the fabrics that leak
    std::vector<double> reference_area;  ///< of each part's stress-free shape          [m^2]
};

}  // namespace corpuscle::gas
