// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/faults.hpp"
#include "io/model/draft.hpp"

namespace corpuscle::io {

/// A fault for a part of a merged body that gravity by parts does not pull as it pulls the lead, by
/// one card or by several: the body falls as a whole. Nodes that are joined into a body have no mass
/// of their own to pull.
void check_merged_loads(const Draft& draft, Faults& faults);

}  // namespace corpuscle::io
