// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/faults.hpp"
#include "io/model/draft.hpp"

/// What is wrong with prescribed motions that no single card can see.
namespace corpuscle::io {

/// A fault for a motion of nodes of a rigid body, and for two motions of a node or body along or
/// about one axis at one time; a warning for one along what is held, where the motion counts.
void check_motions(Draft& draft, Faults& faults);

/// A warning for curves of loads and motions that do not last from their beginning to the end of
/// the run: outside they keep their end values.
void check_curves(const Draft& draft, Faults& faults);

}  // namespace corpuscle::io
