// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/relax.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

GroupEnergies energies_of(std::span<const Index> rows, const Mixture& mixture,
                          const Particles& particles) {
    thread_local CellSample sample;
    sample.gather(rows, mixture, particles);
    return {sample.translational() + sample.internal(), 0.5 * sample.mass * sample.U.squaredNorm()};
}

double thermal_energy(const Lists& groups, const Mixture& mixture, const Particles& particles) {
    constexpr std::size_t GROUPS_A_CHUNK = 16;
    return parallel::sum(
        groups.size(), 0.0,
        [&](std::size_t g) { return energies_of(groups[g], mixture, particles).thermal; },
        GROUPS_A_CHUNK);
}

double equilibrium_temperature(double energy, double freedom, double half_heat,
                               const EnergyPolynomial& internal) {
    EnergyPolynomial content = internal;
    content.a += freedom * half_heat;
    const double guess = energy / content.a;  // exact for constant heat capacities
    return content.temperature(energy, guess > 0.0 && guess < 5000.0 ? guess : 300.0);
}

bool is_rigid(const CellSample& sample, double translational) {
    return translational <= RIGID * 0.5 * sample.mass * sample.U.squaredNorm();
}

std::optional<double> share(double energy, double freedom, const Mixture& mixture,
                            Fluctuation fluctuation, CellSample& sample, Random& draw) {
    const double chance = nearly_normal(draw);
    const EnergyPolynomial& internal_at = sample.internal_at();
    const double T = equilibrium_temperature(energy, freedom, mixture.half_heat(), internal_at);
    if (!(T > 0.0)) return std::nullopt;

    const double C_t = freedom * mixture.half_heat(), C_i = internal_at.slope(T);
    const double least = std::min(sample.can_give(T, mixture), energy - internal_at(T));
    if (!(C_i > 0.0 && least > 0.0)) {  // a monatomic gas
        sample.set_internal(T, 0.0, MEMORY, mixture);
        return energy - sample.internal();
    }
    const bool is_alone = fluctuation == Fluctuation::ALONE;
    const double part = C_t / (C_t + C_i);
    const double missing = 1.0 - (is_alone ? part : part * part);
    const double spread = T * std::sqrt(2.0 * mixture.half_heat() * C_t * missing);
    const double scatter = T / (C_t + C_i);  // squared: var(T) / (k C_t)
    const double less = (is_alone ? ALONE_SCATTER : SCATTER) * mixture.half_heat() * C_t *
                        internal_at.curvature(T) * scatter * scatter;
    // In groups of two or three the tails are cut, evenly, so that no part is used up.
    const double more = std::clamp(spread * chance - less, -MOST_NOISE * least, MOST_NOISE * least);
    sample.set_internal(T, more, MEMORY, mixture);
    return energy - sample.internal();
}

bool relax(const Mixture& mixture, CellSample& sample, Random& draw) {
    const double translational = sample.translational();
    if (is_rigid(sample, translational)) {
        sample.heat_internal();
        return true;
    }
    const double energy = translational + sample.internal() + sample.heat;
    const double freedom = 3.0 * (static_cast<double>(sample.size()) - 1.0);
    const std::optional<double> left =
        share(energy, freedom, mixture, Fluctuation::ALONE, sample, draw);
    if (left)
        sample.scale(std::sqrt(*left / translational));
    else
        sample.heat_internal();
    return left.has_value();
}

double nearly_normal(Random& draw) {
    const std::uint32_t a = draw.bits(), b = draw.bits();
    const std::uint32_t sum = (a & 0xffffU) + (a >> 16) + (b & 0xffffU) + (b >> 16);
    return std::numbers::sqrt3 * ((sum + 2.0) * 0x1p-16 - 2.0);
}

}  // namespace corpuscle::gas
