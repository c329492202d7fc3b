// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/groups.hpp"
#include "gas/swarm.hpp"

namespace corpuscle::gas {

/// Energy of all motion relative to the groups' mean velocities, and all internal energy.      [J]
double thermal_energy(const Lists& groups, const Mixture& mixture, const Particles& particles);

/// Temperature T at which (freedom/2) k T + sum e_s(T) = energy, for any heat capacity; k T/2
/// stands for `half_heat` T. NaN when there is none. [K]
/// @param freedom  3 for each particle, less those of the motion in common
double equilibrium_temperature(double energy, double freedom, double half_heat,
                               const EnergyPolynomial& internal);

/// Is c nothing but rounding? A lone particle and a cold jet have no thermal motion to be scaled.
bool is_rigid(const Swarm& swarm, double translational);

/// Gives every particle its internal energy at T; returns the sum.                             [J]
double set_internal(double T, const Mixture& mixture, Swarm& swarm);

/// Shares a swarm's thermal energy, times `heat`, between translation and internal energy as at
/// equilibrium (eq. 18-21): one factor on c, a new e each. Exact in energy and momentum. The heat
/// of a rigid swarm goes to its internal energy. Where no temperature holds the energy both parts
/// are multiplied by `heat`, and false is returned.
bool relax(double heat, const Mixture& mixture, Swarm& swarm);

/// As relax(), where nothing can be shared.
void scale_energies(double heat, Swarm& swarm);

}  // namespace corpuscle::gas
