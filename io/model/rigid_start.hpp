// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/model.hpp"

namespace corpuscle::io {

/// Rigid parts whose nodes were given initial velocities, and that have none of their own, get the
/// motion that has the nodes' momentum and angular momentum.
void start_rigid_parts(Model& model);

}  // namespace corpuscle::io
