// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>

#include "io/deck/card.hpp"
#include "io/deck/faults.hpp"
#include "io/deck/included/file_place.hpp"
#include "io/deck/included/id_kind.hpp"
#include "io/deck/parameters.hpp"

namespace corpuscle::io {

/// A file that *INCLUDE_TRANSFORM brings in, and all that it includes in turn.
struct Inclusion {
    Block block;                 ///< its cards; block.inclusion is the one around it
    std::size_t name_lines = 0;  ///< of the block, up to the end of FILENAME
    std::string name;            ///< FILENAME
    IdOffsets offsets{};         ///< its own and those around it, in sum
    FilePlace place;             ///< of its own transformation and of those around it
};

/// Reads the cards behind FILENAME, but for TRANID, in the order in which the files were met.
/// Unit factors other than 1 are faults.
void read_offsets(std::deque<Inclusion>& inclusions, const Parameters& parameters, Faults& faults);

/// Row of the transformation that TRANID names; -1: none, or a fault.
Index transformation_of(const Inclusion& inclusion, const Registry& transformations,
                        const Parameters& parameters, Faults& faults);

/// What an id that is written in the block stands for: its magnitude is shifted, 0 stays 0. None:
/// it would be no id.
[[nodiscard]] std::optional<int> shifted_id(const Block& block, IdKind kind, double written);

/// "nodes + 1000, parts + 10", of the offsets that are not 0; empty: none.
[[nodiscard]] std::string told(const IdOffsets& offsets);

}  // namespace corpuscle::io
