// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/model.hpp"

namespace corpuscle {

/// Rigid parts whose nodes have velocities at the start, and that have none of their own, get the
/// motion that has the nodes' momentum and angular momentum:
///
///     V = sum m v / sum m,      I spin = sum m r x v about the centre of mass,
///
/// m the masses of all nodes of the body. A part with *PART_INERTIA, of solids or of beams takes
/// part with its own mass, in the motion that its nodes have in the mean: weighted by the area of
/// its shells, else by their masses, else alike.
/// @param node_mass  N, with that of tied nodes at those that bear it                     [kg]
/// @param velocity   N, likewise                                                         [m/s]
void start_rigid_parts(Model& model, const std::vector<double>& node_mass, const Points& velocity);

}  // namespace corpuscle
