// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What a bag's particles and initial air hold.

#include <algorithm>
#include <cmath>

#include "gas/particle_gas.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

std::vector<Holding> ParticleGas::holdings() const {
    const std::size_t kinds = bag_.particle_mass.size(), rows = bag_.surface->rooms() * kinds;
    const std::size_t n = particles_.size();
    std::vector<Holding> part(parallel::chunk_count(n) * rows);
    parallel::for_chunks(n, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Holding* const own = part.data() + chunk * rows;
        for (std::size_t i = begin; i < end; ++i) {
            const auto s = static_cast<std::size_t>(particles_.species[i]);
            Holding& holding = own[particles_.room_of(i) * kinds + s];
            const Vec3& v = particles_.v[i];
            holding.count += 1.0;
            holding.translational += 0.5 * bag_.particle_mass[s] * v.squaredNorm();
            holding.momentum += bag_.particle_mass[s] * v;
            holding.internal += particles_.e[i];
        }
    });
    std::vector<Holding> all(rows);
    for (std::size_t k = 0; k < part.size(); ++k) all[k % rows] += part[k];
    for (std::size_t k = 0; k < rows; ++k)
        all[k].mass = all[k].count * bag_.particle_mass[k % kinds];
    return all;
}

namespace {

/// Of all gases in one room.
Holding in_room(std::span<const Holding> holds, std::size_t room, std::size_t kinds) {
    Holding sum;
    for (const Holding& own : holds.subspan(room * kinds, kinds)) sum += own;
    return sum;
}

}  // namespace

double ParticleGas::energy() const {
    double sum = 0.0;
    for (const Holding& holding : holdings()) sum += holding.all();
    for (const InitialAir& air : bag_.air) sum += air.energy();
    return sum;
}

void ParticleGas::describe(GasState& now) const {
    EnergyPolynomial content;
    const auto include = [&](double mass, double energy, double translational,
                             const EnergyPolynomial& of_gas) {
        now.species.push_back({mass, mass > 0.0 ? of_gas.temperature(energy) : 0.0, energy});
        now.mass += mass;
        now.energy += energy;
        now.translational += translational;
        content += of_gas;
    };
    if (!bag_.air.empty()) {
        double mass = 0.0, energy = 0.0, translational = 0.0;
        EnergyPolynomial of_air;
        for (const InitialAir& air : bag_.air) {
            mass += air.mass();
            energy += air.energy();
            translational += air.translational();
            of_air += air.content();
        }
        include(mass, energy, translational, of_air);
    }
    const std::vector<Holding> holds = holdings();
    const std::size_t kinds = bag_.particle_mass.size();
    const auto include_particles = [&](std::size_t s) {
        Holding sum;
        for (std::size_t k = s; k < holds.size(); k += kinds) sum += holds[k];
        include(
            sum.count * bag_.particle_mass[s], sum.all(), sum.translational,
            sum.count * bag_.inflators.moles_each() * bag_.inflators.species()[s].molar_energy());
    };
    if (kinds > bag_.inflators.inflows()) include_particles(bag_.inflators.inflows());
    for (std::size_t s = 0; s < bag_.inflators.inflows(); ++s) include_particles(s);
    now.pressure = 2.0 / 3.0 * now.translational / now.volume;
    now.temperature = now.mass > 0.0 ? content.temperature(now.energy) : 0.0;
    double bulk = 0.0;
    for (std::size_t r = 0; r < bag_.surface->rooms(); ++r) bulk += in_room(holds, r, kinds).bulk();
    now.static_pressure = 2.0 / 3.0 * std::max(0.0, now.translational - bulk) / now.volume;
    now.static_temperature =
        now.mass > 0.0 ? content.temperature(std::max(0.0, now.energy - bulk)) : 0.0;
}

void ParticleGas::add_rooms(std::span<const double> /*volume*/, std::span<const Index> sum_of,
                            std::span<ChamberSum> sums) const {
    const std::size_t kinds = bag_.particle_mass.size();
    const double moles_each = bag_.inflators.moles_each();
    const std::vector<Holding> holds = holdings();
    for (std::size_t r = 0; r < bag_.surface->rooms(); ++r) {
        if (sum_of[r] < 0) continue;
        ChamberSum& sum = sums[static_cast<std::size_t>(sum_of[r])];
        for (std::size_t s = 0; s < kinds; ++s) {
            const Holding& own = holds[r * kinds + s];
            sum.state.mass += own.mass;
            sum.state.energy += own.all();
            sum.pV += 2.0 / 3.0 * own.translational;
            sum.content += own.count * moles_each * bag_.inflators.species()[s].molar_energy();
        }
        sum.bulk += in_room(holds, r, kinds).bulk();
        if (bag_.air.empty()) continue;
        const InitialAir& air = bag_.air[r];
        sum.state.mass += air.mass();
        sum.state.energy += air.energy();
        sum.pV += 2.0 / 3.0 * air.translational();
        sum.content += air.content();
    }
}

}  // namespace corpuscle::gas
