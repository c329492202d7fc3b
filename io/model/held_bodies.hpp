// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/faults.hpp"
#include "io/model/draft.hpp"

namespace corpuscle::io {

/// Supports of nodes of rigid bodies become those of the bodies, CON1 and CON2: the motions that
/// the nodes leave them are some of the six along and about x, y, z. A fault where they are not.
/// After all keywords.
void hold_bodies(Draft& draft, Faults& faults);

}  // namespace corpuscle::io
