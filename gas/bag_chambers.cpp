// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A bag's gas chamber by chamber.

#include <algorithm>

#include "gas/bag_gas.hpp"

namespace corpuscle::gas {

std::vector<Index> BagGas::rooms_of(std::span<const Vec3> points, const Points& x) const {
    return chambers_.empty() ? std::vector<Index>(points.size(), 0) : chambers_.of(points, x);
}

/// With particles: those in it, and its share of the initial air by volume.
std::vector<ChamberState> BagGas::chamber_states(const Points& x) const {
    std::vector<ChamberState> all(chambers_.size());
    if (uniform_) {
        for (std::size_t c = 0; c < all.size(); ++c) {
            const ControlVolume& gas = (*uniform_)[c];
            all[c] = {gas.volume(), gas.pressure(), gas.temperature(), gas.mass(), gas.energy()};
        }
        return all;
    }
    if (all.empty()) return all;
    std::vector<EnergyPolynomial> content(all.size());
    std::vector<double> translational(all.size(), 0.0);
    const double volume = enclosure_.volume(x);
    for (std::size_t c = 0; c < all.size(); ++c) {
        all[c].volume = chambers_.surface(c).volume(x);
        if (!air_) continue;
        const double share = all[c].volume / volume;
        content[c] += share * air_->content();
        all[c].mass = share * air_->mass();
        all[c].energy = share * air_->energy();
        translational[c] = share * air_->translational();
    }
    const std::vector<Index> room = chambers_.of(particles_.x, x);
    for (std::size_t i = 0; i < room.size(); ++i) {
        const std::int32_t s = particles_.species[i];
        const double kinetic = 0.5 * mass_[s] * particles_.v[i].squaredNorm();
        all[room[i]].mass += mass_[s];
        all[room[i]].energy += kinetic + particles_.e[i];
        translational[room[i]] += kinetic;
        content[room[i]] += inflators_.moles_each() * inflators_.species()[s].molar_energy();
    }
    for (std::size_t c = 0; c < all.size(); ++c) {
        all[c].pressure = 2.0 / 3.0 * translational[c] / all[c].volume;
        all[c].temperature = all[c].mass > 0.0 ? content[c].temperature(all[c].energy) : 0.0;
    }
    return all;
}

/// Books the pressure that no particles bring, for the means of parts and shells.
void BagGas::note_air(double span) {
    for (std::size_t r = 0; r < part_air_.size(); ++r) {
        const double pressure = uniform_ ? (*uniform_)[r].pressure() : air_pressure();
        part_air_[r] += pressure * span;
        triangle_air_[r] += pressure * span;
    }
}

double BagGas::air_on(std::size_t facet, std::span<const double> of_room) const {
    const bool closes = facet < walls_.closing;
    if (chambers_.empty()) return closes ? of_room[0] : 0.0;
    const auto [behind, ahead] = chambers_.beside(facet);
    const double push = (behind >= 0 ? of_room[behind] : 0.0);
    const double against = (ahead >= 0 ? of_room[ahead] : 0.0);
    return closes ? push + against : push - against;
}

}  // namespace corpuscle::gas
