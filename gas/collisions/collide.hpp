// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/cards/collision_model.hpp"
#include "gas/collisions/groups.hpp"
#include "gas/collisions/relax.hpp"
#include "gas/particles.hpp"
#include "gas/thermo/species.hpp"
#include "solver/base/constants.hpp"

namespace corpuscle::gas {

/// Heat given to groups, or taken from them: E' = factor E + per_mass m. None is taken from a group
/// without relative motion whose e is too small.
///
/// A factor above 1 would amplify differences of particles' energies, so heat is given per mass;
/// one below 1 reduces them and leaves no energy below zero, so heat is taken by a factor.
struct Heat {
    double factor = 1.0;    ///< on thermal energy                                      [-]
    double per_mass = 0.0;  ///< [J/kg]
};

/// Input of one collision step of all groups.
struct CollisionStep {
    Lists groups;
    const Mixture& mixture;
    Heat heat;             ///< of each group
    double dt;             ///< since the last collision step                       [s]
    double volume;         ///< of a cell                                           [m^3]
    double cross_section;  ///< pi d² of the spheres; 0 where a model has none      [m^2]
    std::uint64_t seed;
    std::uint64_t step;                    ///< counts collision steps: no two draw the same numbers
    std::span<const Heat> heat_of_room{};  ///< in place of `heat`, by room; empty: none

    [[nodiscard]] Heat heat_of(std::span<const Index> rows, const Particles& particles) const {
        return heat_of_room.empty()
                   ? heat
                   : heat_of_room[particles.room_of(static_cast<std::size_t>(rows[0]))];
    }
};

/// Exceptional events of a collision step.
struct CollisionReport {
    double thermal = 0.0;       ///< energy of all groups that heat has changed, before         [J]
    std::size_t unrelaxed = 0;  ///< groups whose energy has no temperature; left unchanged
    double refused = 0.0;       ///< heat that could not be taken from groups               [J]
    CollisionReport& operator+=(const CollisionReport& o) {
        thermal += o.thermal;
        refused += o.refused;
        unrelaxed += o.unrelaxed;
        return *this;
    }
};

CollisionReport collide_pairs(const CollisionStep& step, Particles& particles);
CollisionReport collide_lin(const CollisionStep& step, Particles& particles);
/// The same map, group by group and sum by sum: what collide_lin() is held to.
CollisionReport collide_lin_plainly(const CollisionStep& step, Particles& particles);
CollisionReport collide_ntc(const CollisionStep& step, Particles& particles);
CollisionReport collide_spheres(const CollisionStep& step, Particles& particles);

/// What the groups of a room hold.
struct RoomGroups {
    double groups = 0.0;  ///< how many
    GroupEnergies energies;
    std::vector<double> count;  ///< particles of each kind
};

/// Collisions and internal energy of a bag's particles, from sorting to scattering.
///
///     collider.find_groups(grid, fabric, particles);
///     const CollisionReport report = collider.collide(step, dt, heat, particles);
class Collider {
public:
    /// @param mean_free_path  of NTC and SPHERES at the mean density of the cells that hold
    ///                        particles [m]; NaN: as many mean distances of particles as
    ///                        default_free_path() says
    Collider(std::vector<Species> species, double moles_each, std::uint64_t seed,
             CollisionModel model = CollisionModel::LIN, double mean_free_path = NaN);

    /// Lists particles by cell, and in cells with fabric tells sides apart; `moves_rows`: puts them
    /// in the order of cells, too (CellSort). Valid until rows or places change.
    void find_groups(const Grid& grid, const FabricInCells& fabric, Particles& particles,
                     bool moves_rows = true);

    /// Energy of all motion relative to the groups' mean velocities, and all internal energy. [J]
    /// What collide(heat) multiplies.
    [[nodiscard]] double thermal_energy(const Particles& particles) const;
    /// What the groups of each room hold. A group before an open hole may reach into the next room:
    /// it counts whole where its first particle is, as for heat.
    /// @param kinds  rows of particles.species: inflators, and initial air
    [[nodiscard]] std::vector<RoomGroups> groups_of_rooms(std::size_t rooms, std::size_t kinds,
                                                          const Particles& particles) const;

    /// One collision step of every group, for the time dt that has gone by since the last one;
    /// thermal energy is multiplied by `factor` on the way.
    CollisionReport collide(std::uint64_t step, double dt, double factor,
                            Particles& particles) const;
    /// The same with the heat of each room; empty: none.
    CollisionReport collide(std::uint64_t step, double dt, std::span<const Heat> heat_of_room,
                            Particles& particles) const;

    [[nodiscard]] const Groups& groups() const { return groups_; }
    [[nodiscard]] const Mixture& mixture() const { return mixture_; }
    [[nodiscard]] Lists cells() const { return cells_.cells(); }

private:
    [[nodiscard]] double cross_section() const;
    [[nodiscard]] CollisionReport collide(const CollisionStep& step, Particles& particles) const;

    Mixture mixture_;
    std::uint64_t seed_;
    CollisionModel model_;
    double mean_free_path_;     ///< NaN: the default                                [m]
    double cell_volume_ = 0.0;  ///< [m^3]
    CellSort cells_;
    Groups groups_;
};

}  // namespace corpuscle::gas
