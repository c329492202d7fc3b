// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "gas/enclosure/enclosure.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/particles.hpp"
#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// Particles that rest in the bag at the start (IAIR = 2).
struct ResidentAir {
    std::size_t count = 0;
    std::int32_t species = 0;   ///< row among the bag's species
    std::int32_t first_id = 0;  ///< ids run from here
    double mass = NaN;          ///< of one particle                              [kg]
    double temperature = NaN;   ///< [K]
};

/// Adds them: evenly spread over the volume inside, in every room as many as its share of the
/// volume, rounded up or down by chance, with velocities after Maxwell and Boltzmann. In each room
/// of two or more their momentum is zero and their energy is count · mass · u(T), 3/2 R T / M of
/// it translation, both to rounding.
///
/// What each gets is a function of (seed, id) and of the rooms.
/// Errors: InputError, naming `bag`, when the bag holds next to no volume for its size.
void add_resident_air(const ResidentAir& air, const Species& gas, const Enclosure& bag,
                      const WettedSurface& surface, std::span<const Vec3> x, std::uint64_t seed,
                      const std::string& name, Particles& particles);

}  // namespace corpuscle::gas
