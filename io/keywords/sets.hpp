// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "io/card.hpp"
#include "io/draft.hpp"

/// What all *SET_ keywords have in common.
namespace corpuscle::io::keywords {

/// The header card, its id taken for `row`.
void set_header(Cards& cards, Registry& sets, std::size_t row);

/// Each item once, in the order of first mention; none at all is a fault.
void close_set(Cards& cards, std::vector<Index>& items);

using Segments = std::vector<std::array<Index, 4>>;
void close_set(Cards& cards, Segments& items);

}  // namespace corpuscle::io::keywords
