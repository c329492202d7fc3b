// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// A bag's gas chamber by chamber, and room by room.

#include <algorithm>

#include "gas/bag_gas.hpp"

namespace corpuscle::gas {

/// What the rooms of each chamber hold together: most often one.
std::vector<ChamberState> BagGas::chamber_states(const Points& x) const {
    std::vector<ChamberState> all(chambers_.size());
    if (all.empty()) return all;
    std::vector<double> volume;
    surface_->volumes(x, volume);
    const std::size_t kinds = mass_.size();
    std::vector<Holding> holds;
    if (!uniform_) holds = holdings();
    std::vector<EnergyPolynomial> content(all.size());
    std::vector<double> pV(all.size(), 0.0);
    for (std::size_t r = 0; r < surface_->rooms(); ++r) {
        const auto c = static_cast<std::size_t>(chamber_of_room_[r]);
        ChamberState& now = all[c];
        now.volume += volume[r];
        if (uniform_) {
            const ControlVolume& gas = (*uniform_)[r];
            now.mass += gas.mass();
            now.energy += gas.energy();
            pV[c] += gas.pressure() * volume[r];
            for (std::size_t s = 0; s < gas.species().size(); ++s)
                content[c] += gas.moles(s) * gas.species()[s].molar_energy();
            continue;
        }
        for (std::size_t s = 0; s < kinds; ++s) {
            const Holding& own = holds[r * kinds + s];
            now.mass += own.count * mass_[s];
            now.energy += own.all();
            pV[c] += 2.0 / 3.0 * own.translational;
            content[c] +=
                own.count * inflators_.moles_each() * inflators_.species()[s].molar_energy();
        }
        if (air_.empty()) continue;
        now.mass += air_[r].mass();
        now.energy += air_[r].energy();
        pV[c] += 2.0 / 3.0 * air_[r].translational();
        content[c] += air_[r].content();
    }
    for (std::size_t c = 0; c < all.size(); ++c) {
        all[c].pressure = pV[c] / all[c].volume;
        all[c].temperature = all[c].mass > 0.0 ? content[c].temperature(all[c].energy) : 0.0;
    }
    return all;
}

/// Books the pressure that no particles bring, for the means of parts and shells.
void BagGas::note_air(double span) {
    for (std::size_t r = 0; r < part_air_.size(); ++r) {
        part_air_[r] += air_pressure(r) * span;
        triangle_air_[r] += air_pressure(r) * span;
    }
}

double BagGas::air_on(std::size_t facet, std::span<const double> of_room) const {
    const double push = of_room[surface_->room(surface_->side(facet, false))];
    if (facet < walls_.closing) return push;
    return push - of_room[surface_->room(surface_->side(facet, true))];
}

}  // namespace corpuscle::gas
