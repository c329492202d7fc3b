// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/model/draft.hpp"

namespace corpuscle::io::keywords {

/// Gives rigid materials of CMO = -1 their axes, once all nodes are where they start.
void place_local_axes(Draft& draft);

}  // namespace corpuscle::io::keywords
