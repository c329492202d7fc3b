// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "gas/collisions/cell_sample.hpp"
#include "gas/collisions/groups.hpp"

namespace corpuscle::gas {

/// Energies of a group: of motion relative to its mean velocity, with internal energy; of the mean
/// motion.                                                                                     [J]
struct GroupEnergies {
    double thermal = 0.0, mean_motion = 0.0;
    GroupEnergies& operator+=(const GroupEnergies& o) {
        thermal += o.thermal;
        mean_motion += o.mean_motion;
        return *this;
    }
};
GroupEnergies energies_of(std::span<const Index> rows, const Mixture& mixture,
                          const Particles& particles);
/// Thermal energy of all groups.                                                               [J]
double thermal_energy(const Lists& groups, const Mixture& mixture, const Particles& particles);

/// Temperature T at which (freedom/2) k T + sum e_s(T) = energy, for any heat capacity; k T/2
/// stands for `half_heat` T. NaN when there is none. [K]
/// @param freedom  3 for each particle, less those of the motion in common
double equilibrium_temperature(double energy, double freedom, double half_heat,
                               const EnergyPolynomial& internal);

/// What a particle keeps of its e's deviation from the mean of its kind in the group, if that
/// leaves no e below zero. At 0 every collision step would conduct heat across the whole cell and
/// smear contacts (Sod's tube at 10^5 particles: L1 of density .0118, here .0105).
inline constexpr double MEMORY = 0.95;
inline constexpr double MOST_NOISE =
    0.8;  ///< share of the smaller part that fluctuation may take away

/// Variance of the share of translation E_t when a group's energy is given (C_t, C_i: heat
/// capacities of the two parts, C = C_t + C_i).
enum class Fluctuation : std::uint8_t {
    ALONE,  ///< k T² C_t C_i / C, of a group in equilibrium with itself
    /// k T² C_t (1 - (C_t / C)²): with groups' energies, which scatter by k T² C_t and not k T² C, for
    /// particles carry nearly the same e, it makes k T² C_t, that of a gas at equilibrium.
    IN_GAS,
};

/// Where heat capacities rise with temperature, n e(T) of groups whose temperatures scatter is on
/// average C_i' var(T) / 2 above that of the gas as a whole; so much less is given to e.
/// Translation alone makes var(T) = k T² C_t / C². Of that groups show this share, for they trade e
/// with their neighbours: measured, by the pressure of carbon dioxide at rest and by
/// `slow_compression_cp`; SCATTER with IN_GAS, ALONE_SCATTER with ALONE.
inline constexpr double SCATTER = 0.45;
inline constexpr double ALONE_SCATTER = 0.64;

/// Of the energy of a sample's common motion: (the rounding of c = v - U, some 1e-16 v, times 1000)²
inline constexpr double RIGID = 1e-26;

/// Is c nothing but rounding? A lone particle and a cold jet have no thermal motion to be scaled.
bool is_rigid(const CellSample& sample, double translational);

/// Shares `energy` between translation and internal energy as at equilibrium (eq. 18-21): sets e
/// and returns what is left for translation, exactly. None, and nothing done, when no temperature
/// holds it.
///
/// The shares fluctuate. Without this the groups' common motion, that compression and relaxation
/// damp, would be colder than the gas.
std::optional<double> share(double energy, double freedom, const Mixture& mixture,
                            Fluctuation fluctuation, CellSample& sample, Random& draw);

/// Shares out a sample's thermal energy and its heat: one factor on c, a new e each. Exact in energy
/// and momentum. The heat of a rigid sample goes to its internal energy (heat_internal()); so it does
/// where no temperature holds the energy, and false is returned.
bool relax(const Mixture& mixture, CellSample& sample, Random& draw);

/// Close to standard normal, never beyond 3.5: the sum of four uniform numbers. Noise needs no
/// tails.
double nearly_normal(Random& draw);

}  // namespace corpuscle::gas
