// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

#include "io/deck/faults.hpp"
#include "io/deck/parameters.hpp"

namespace corpuscle::io {

/// Settings of the program in a deck's comments, which other programs skip:
///
///     $ corpuscle: UNITS = lbf-in-s, CLOSE = no
///
/// Each is as a *PARAMETER of type C: -D goes before it, the first one stays. A name that is no setting
/// is a fault.
///
/// @param text  of a whole file
void read_comment_settings(std::string_view text, std::uint32_t file, Parameters& parameters,
                           Faults& faults);

}  // namespace corpuscle::io
