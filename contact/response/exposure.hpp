// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// How far the nearest places of a pair face each other: 1, or less where a piece of cloth beside
/// one of them is nearer to the other, down to 0.
///
/// A place on an edge or a node of a sheet is the sheet's nearest to some point only if no
/// triangle there leads towards that point: with d the direction to it, and u in the plane of a
/// triangle, off the edge (or along an edge, off the node), d · u <= 0. Of flat sheets that
/// slide on each other faces and nodes alone remain, so contact is normal to the sheets
/// [Chen et al. 2025, offset geometric contact]. The value falls from 1 to 0 as the sine of the
/// angle by which that is missed grows from 0 to 0.05; of two edges from -0.02 to 0: in flat
/// sheets they have nothing to add.
[[nodiscard]] double exposure(const Cloth& cloth, const Points& x, const Pair& pair,
                              const Nearest& nearest);

}  // namespace corpuscle::contact
