// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Collisions in a bag, and the heat that comes to its particles with them.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gas/particle_gas.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::gas {
namespace {

/// Share of the particles' thermal energy that they trade with the initial air in one collision
/// step at most; the rest follows in the next ones.
constexpr double MOST_EXCHANGED = 0.3;

}  // namespace

void ParticleGas::collide(double dt, const Points& x) {
    const bool is_due = cells_.is_due(dt);
    if (particles_.size() == 0) cells_.pass_empty();
    if (!is_due || particles_.size() == 0) return;
    cells_.find_groups(x, bag_.openings.transmission(), collider_, particles_);
    std::vector<Heat> heat;
    std::vector<double> after;  // energy of each room's particles, with that heat         [J]
    if (!bag_.air.empty()) exchange_heat_with_air(heat, after);
    const CollisionReport report =
        collider_.collide(cells_.steps(), cells_.since(), heat, particles_);
    check_collided(report.thermal);
    if (report.refused > 0.0) return_heat_to_air(after);
    unrelaxed_ += report.unrelaxed;
    cells_.finish(collider_.cells(), bag_.particle_mass, particles_);
}

/// Stops where the groups' energies, all added up, are not finite.
void ParticleGas::check_collided(double thermal) const {
    if (std::isfinite(thermal)) return;
    for (std::size_t i = 0; i < particles_.size(); ++i)
        if (!(particles_.x[i].squaredNorm() + particles_.v[i].squaredNorm() +
                  std::abs(particles_.e[i]) <
              INF))
            stop_for(i, "at its collisions");
    throw PhysicsError(bag_.time,
                       fmt::format("{}: the thermal energy of its particles overflows at "
                                   "their collisions",
                                   bag_.name()));
}

/// Brings the initial air of each room to the mean temperature of its particles: finds the heat of
/// the room's groups, and takes it from the air.
///
///     E_air(T) + E_particles(T) = E_air + E_thermal
///
/// A group's mean motion is no heat, so N particles in G groups hold 3/2 (N - G) R T of
/// translation.
void ParticleGas::exchange_heat_with_air(std::vector<Heat>& heat, std::vector<double>& after) {
    const std::size_t kinds = bag_.particle_mass.size();
    const std::vector<RoomGroups> rooms =
        collider_.groups_of_rooms(bag_.air.size(), kinds, particles_);
    heat.assign(rooms.size(), {});
    after.assign(rooms.size(), 0.0);
    const double moles = bag_.inflators.moles_each();
    for (std::size_t r = 0; r < rooms.size(); ++r) {
        const double thermal = rooms[r].energies.thermal;
        after[r] = thermal + rooms[r].energies.mean_motion;
        if (!(thermal > 0.0)) continue;
        EnergyPolynomial content = bag_.air[r].content();
        double count = 0.0, mass = 0.0;
        for (std::size_t s = 0; s < kinds; ++s) {
            content += rooms[r].count[s] * moles * bag_.inflators.species()[s].molar_internal();
            count += rooms[r].count[s];
            mass += rooms[r].count[s] * bag_.particle_mass[s];
        }
        content.a += 1.5 * bag_.card.gas_constant * moles * (count - rooms[r].groups);
        const double T =
            content.temperature(bag_.air[r].energy() + thermal, bag_.air[r].temperature());
        const double wanted = bag_.air[r].energy() - bag_.air[r].content()(T);
        const double given =
            std::clamp(wanted, -MOST_EXCHANGED * thermal, MOST_EXCHANGED * thermal);
        heat[r] = given > 0.0 ? Heat{1.0, given / mass} : Heat{1.0 + given / thermal, 0.0};
        bag_.air[r].add(-given);
        after[r] += given;
    }
}

/// The air gives back what groups had not to give.
/// @param expected  energy of each room's groups, had they given it                       [J]
void ParticleGas::return_heat_to_air(std::span<const double> expected) {
    const std::vector<RoomGroups> rooms =
        collider_.groups_of_rooms(bag_.air.size(), bag_.particle_mass.size(), particles_);
    for (std::size_t r = 0; r < rooms.size(); ++r) {
        const GroupEnergies& there = rooms[r].energies;
        bag_.air[r].add(expected[r] - there.thermal - there.mean_motion);
    }
}

}  // namespace corpuscle::gas
