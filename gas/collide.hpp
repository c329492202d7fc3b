// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gas/groups.hpp"
#include "gas/particles.hpp"
#include "gas/species.hpp"

namespace corpuscle::gas {

/// How particles of a group trade momentum. All keep the group's mass, momentum and energy to
/// rounding.
enum class CollisionModel {
    PAIRS,  ///< each particle collides with one other, drawn at random: the plain kinetic picture
    LIN,  ///< the group's stress is over-relaxed by one linear map: sharper waves (collide_lin.cpp)
};

/// What a model needs to know to collide all groups once.
struct CollisionStep {
    Lists groups;
    const Mixture& mixture;
    double heat;  ///< factor on each group's thermal energy, 1: none                [-]
    std::uint64_t seed;
    std::uint64_t step;  ///< counts collision steps: no two draw the same numbers
};

/// What went other than planned.
struct CollisionReport {
    double thermal = 0.0;  ///< energy of all groups that `heat` has multiplied, before    [J]
    std::size_t unrelaxed =
        0;  ///< groups whose energy belongs to no temperature; it was left where it is
    CollisionReport& operator+=(const CollisionReport& o) {
        thermal += o.thermal;
        unrelaxed += o.unrelaxed;
        return *this;
    }
};

CollisionReport collide_pairs(const CollisionStep& step, Particles& particles);
CollisionReport collide_lin(const CollisionStep& step, Particles& particles);

/// Collisions and internal energy of a bag's particles, from sorting to scattering.
///
///     collider.find_groups(grid, fabric, particles);
///     const CollisionReport report = collider.collide(step, heat, particles);
///     brought_in += (heat - 1) * report.thermal;
class Collider {
public:
    Collider(std::vector<Species> species, double moles_each, std::uint64_t seed,
             CollisionModel model = CollisionModel::LIN);

    /// Puts particles in the order of cells, and in cells with fabric tells sides apart. Valid until
    /// rows or places change.
    void find_groups(const Grid& grid, const FabricInCells& fabric, Particles& particles);

    /// Energy of all motion relative to the groups' mean velocities, and all internal energy. [J]
    /// What collide(heat) multiplies.
    [[nodiscard]] double thermal_energy(const Particles& particles) const;

    /// One collision step of every group; thermal energy is multiplied by `heat` on the way.
    CollisionReport collide(std::uint64_t step, double heat, Particles& particles) const;

    [[nodiscard]] const Groups& groups() const { return groups_; }
    [[nodiscard]] const Mixture& mixture() const { return mixture_; }
    [[nodiscard]] Lists cells() const { return cells_.cells(); }

private:
    Mixture mixture_;
    std::uint64_t seed_;
    CollisionModel model_;
    CellSort cells_;
    Groups groups_;
};

}  // namespace corpuscle::gas
