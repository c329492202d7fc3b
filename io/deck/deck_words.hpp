// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

#include "solver/base/fault.hpp"

namespace corpuscle::io {

/// The deck's field for what of a scene is at fault, "SID3" for the wall of a vent; empty where it
/// has none. `of`: what the fault is of, "*AIRBAG_WANG_NEFSKE 7".
[[nodiscard]] std::string_view deck_word(Property property, std::string_view of);

}  // namespace corpuscle::io
