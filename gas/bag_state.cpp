// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// What the gas of a bag looks like from outside.

#include <algorithm>
#include <cmath>

#include "gas/bag_gas.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

std::vector<BagGas::Holding> BagGas::holdings() const {
    const std::size_t kinds = mass_.size(), rows = surface_->rooms() * kinds;
    const std::size_t n = particles_.size();
    std::vector<Holding> part(parallel::chunk_count(n) * rows);
    parallel::for_chunks(n, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Holding* const own = part.data() + chunk * rows;
        for (std::size_t i = begin; i < end; ++i) {
            const auto s = static_cast<std::size_t>(particles_.species[i]);
            Holding& holding = own[particles_.room_of(i) * kinds + s];
            holding.count += 1.0;
            holding.translational += 0.5 * mass_[s] * particles_.v[i].squaredNorm();
            holding.internal += particles_.e[i];
        }
    });
    std::vector<Holding> all(rows);
    for (std::size_t k = 0; k < part.size(); ++k) {
        Holding& sum = all[k % rows];
        sum.count += part[k].count;
        sum.translational += part[k].translational;
        sum.internal += part[k].internal;
    }
    return all;
}

double BagGas::energy() const {
    if (uniform_) return uniform_->energy();
    double sum = 0.0;
    for (const Holding& holding : holdings()) sum += holding.all();
    for (const InitialAir& air : air_) sum += air.energy();
    return sum;
}

GasState BagGas::state(const Points& x) const {
    if (uniform_) return uniform_state(x);
    GasState now;
    now.volume = enclosure_.volume(x);
    now.area = enclosure_.area(x);
    now.mass_in = mass_in_;
    now.mass_out_vent = openings_.mass_out(true);
    now.mass_out_fabric = openings_.mass_out(false);
    now.particles_out = static_cast<double>(openings_.particles_out());
    EnergyPolynomial content;
    const auto include = [&](double mass, double energy, double translational,
                             const EnergyPolynomial& of_gas) {
        now.species.push_back({mass, mass > 0.0 ? of_gas.temperature(energy) : 0.0, energy});
        now.mass += mass;
        now.energy += energy;
        now.translational += translational;
        content += of_gas;
    };
    if (!air_.empty()) {
        double mass = 0.0, energy = 0.0, translational = 0.0;
        EnergyPolynomial of_air;
        for (const InitialAir& air : air_) {
            mass += air.mass();
            energy += air.energy();
            translational += air.translational();
            of_air += air.content();
        }
        include(mass, energy, translational, of_air);
    }
    const std::vector<Holding> holds = holdings();
    const auto include_particles = [&](std::size_t s) {
        Holding sum;
        for (std::size_t k = s; k < holds.size(); k += mass_.size()) {
            sum.count += holds[k].count;
            sum.translational += holds[k].translational;
            sum.internal += holds[k].internal;
        }
        include(sum.count * mass_[s], sum.all(), sum.translational,
                sum.count * inflators_.moles_each() * inflators_.species()[s].molar_energy());
    };
    if (mass_.size() > inflators_.inflows()) include_particles(inflators_.inflows());
    for (std::size_t s = 0; s < inflators_.inflows(); ++s) include_particles(s);
    now.pressure = 2.0 / 3.0 * now.translational / now.volume;
    now.temperature = now.mass > 0.0 ? content.temperature(now.energy) : 0.0;
    return now;
}

PartState BagGas::part_state(const Points& x, double since) {
    PartState parts{std::vector<double>(part_impulse_.size(), 0.0),
                    std::vector<double>(part_impulse_.size(), 0.0),
                    {openings_.part_mass_out().begin(), openings_.part_mass_out().end()},
                    {heat_loss_.part_heat().begin(), heat_loss_.part_heat().end()}};
    if (since == 0.0)
        for (std::size_t r = 0; r < part_air_.size(); ++r) part_air_[r] = air_pressure(r);
    const double time = since > 0.0 ? since : 1.0;
    std::vector<double> air(part_impulse_.size(), 0.0);
    for (std::size_t t = 0; t < walls_.triangles.size(); ++t) {
        const auto& [a, b, c] = walls_.triangles[t];
        const double size = vector_area(x[a], x[b], x[c]).norm();
        parts.area[walls_.part[t]] += size;
        air[walls_.part[t]] += size * air_on(t, part_air_) / time;
    }
    for (std::size_t p = 0; p < parts.area.size(); ++p) {
        const double particles = since > 0.0 ? part_impulse_[p] / since : 0.0;
        parts.pressure[p] = (air[p] + particles) / parts.area[p];
        part_impulse_[p] = 0.0;
    }
    std::fill(part_air_.begin(), part_air_.end(), 0.0);
    return parts;
}

double BagGas::mass_rate_in(double since) {
    const double rate = since > 0.0 ? (mass_in_ - mass_in_seen_) / since : 0.0;
    mass_in_seen_ = mass_in_;
    return rate;
}

double BagGas::mass_rate_out(double since) {
    const double out = openings_.mass_out(true) + openings_.mass_out(false);
    const double rate = since > 0.0 ? (out - mass_out_seen_) / since : 0.0;
    mass_out_seen_ = out;
    return rate;
}

void BagGas::add_shell_load(const Points& x, double since, std::span<double> force,
                            std::span<double> area) {
    if (since == 0.0)
        for (std::size_t r = 0; r < triangle_air_.size(); ++r) triangle_air_[r] = air_pressure(r);
    const double time = since > 0.0 ? since : 1.0;
    for (std::size_t t = 0; t < walls_.triangles.size(); ++t) {
        const auto& [a, b, c] = walls_.triangles[t];
        const double size = vector_area(x[a], x[b], x[c]).norm();
        const Index shell = walls_.shell[t];
        area[shell] += size;
        force[shell] += air_on(t, triangle_air_) / time * size;
        if (t < walls_.closing) force[shell] -= card_.p_atm * size;
        if (since > 0.0) force[shell] += triangle_impulse_[t] / since;
        triangle_impulse_[t] = 0.0;
    }
    std::fill(triangle_air_.begin(), triangle_air_.end(), 0.0);
}

double BagGas::expected_share_in(double end_time) const {
    double now = 0.0, all = 0.0;
    for (std::size_t s = 0; s < inflators_.inflows(); ++s) {
        now += inflators_.mass_until(s, std::min(end_time, inflators_.ends()));
        all += inflators_.mass_until(s, inflators_.ends());
    }
    return all > 0.0 ? now / all : 1.0;
}

}  // namespace corpuscle::gas
