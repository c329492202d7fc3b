// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "io/deck/card.hpp"

namespace corpuscle::io {

/// A name on the cards of *INCLUDE_..., without quotes and with / between its folders.
struct FileName {
    std::string name;       ///< empty: there is none
    Line line;              ///< its first
    std::size_t lines = 0;  ///< up to its end, with blank ones before it
};

/// The first name; it may go on over lines that end in " +".
[[nodiscard]] FileName file_name(std::span<const Line> lines);

/// All of them: every further line is a further file.
[[nodiscard]] std::vector<FileName> file_names(std::span<const Line> lines);

}  // namespace corpuscle::io
