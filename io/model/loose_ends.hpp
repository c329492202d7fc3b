// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "io/deck/faults.hpp"
#include "io/model/draft.hpp"

/// What no single keyword can see of the parts and elements of a deck.
namespace corpuscle::io {

/// A fault for elements of a part that has no section, no material, or one that is not read; parts
/// that nothing is of get a material that is nothing. After the elements.
void check_parts(Draft& draft, Faults& faults);

/// Beams of *MAT_RIGID parts become bodies: their nodes ride on the part, and
///
///     m = sum rho A L,   I of thin rods,
///
/// unless *PART_INERTIA says them. A fault where the cross section A is not known.
void make_beam_bodies(Draft& draft, Faults& faults);

/// Leaves out, with a warning that counts them, what cannot act here: other elements that join
/// nodes, if no cloth hangs on them (else a fault); nodal rigid bodies without mass; leakage of
/// materials that close no bag. Solids that are taken as rigid are held where their nodes are.
/// After all keywords.
void settle_loose_ends(Draft& draft, Faults& faults);

/// Where the deck defines a part.
[[nodiscard]] Place place_of(const Draft& draft, Index part);

}  // namespace corpuscle::io
