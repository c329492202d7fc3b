// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/faults.hpp"
#include "io/model/draft.hpp"

/// Supports and motions that meet rigid bodies or each other.
namespace corpuscle::io {

/// Supports of nodes of rigid bodies become those of the bodies, CON1 and CON2: the motions that
/// the nodes leave them are some of the six along and about x, y, z. A fault where they are not.
/// After all keywords.
void hold_bodies(Draft& draft, Faults& faults);

/// A fault for a motion of nodes of a rigid body, and for two motions of a node or body along or
/// about one axis at one time; a warning for one along what is held, where the motion counts.
void check_motions(Draft& draft, Faults& faults);

/// A warning for curves of loads and motions that do not last from their beginning to the end of
/// the run: outside they keep their end values.
void check_curves(const Draft& draft, Faults& faults);

}  // namespace corpuscle::io
