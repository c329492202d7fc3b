// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/relax.hpp"

#include <algorithm>
#include <cmath>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

double thermal_energy(const Lists& groups, const Mixture& mixture, const Particles& particles) {
    constexpr std::size_t GROUPS_A_CHUNK = 64;
    return parallel::sum(
        groups.size(), 0.0,
        [&](std::size_t g) {
            thread_local Swarm swarm;
            swarm.gather(groups[g], mixture, particles);
            return swarm.translational() + swarm.internal();
        },
        GROUPS_A_CHUNK);
}

double equilibrium_temperature(double energy, double freedom, double half_heat,
                               const EnergyPolynomial& internal) {
    EnergyPolynomial content = internal;
    content.a += freedom * half_heat;
    const double guess = energy / content.a;  // exact for constant heat capacities
    return content.temperature(energy, guess > 0.0 && guess < 5000.0 ? guess : 300.0);
}

bool is_rigid(const Swarm& swarm, double translational) {
    constexpr double ROUNDING = 1e-26;  // (the rounding of c = v - U, some 1e-16 v, times 1000)²
    return translational <= ROUNDING * 0.5 * swarm.mass * swarm.U.squaredNorm();
}

double set_internal(double T, const Mixture& mixture, Swarm& swarm) {
    double sum = 0.0;
    for (std::size_t i = 0; i < swarm.size(); ++i) {
        swarm.e[i] = mixture.particle_internal(swarm.species[i])(T);
        sum += swarm.e[i];
    }
    return sum;
}

void scale_energies(double heat, Swarm& swarm) {
    swarm.scale(std::sqrt(heat));
    for (double& e : swarm.e) e *= heat;
}

bool relax(double heat, const Mixture& mixture, Swarm& swarm) {
    const double translational = swarm.translational();
    const double internal = swarm.internal();
    const double energy = heat * (translational + internal);
    if (is_rigid(swarm, translational)) {
        for (double& e : swarm.e) e *= heat;
        return true;
    }
    const double freedom = 3.0 * (static_cast<double>(swarm.size()) - 1.0);
    const double T =
        equilibrium_temperature(energy, freedom, mixture.half_heat(), swarm.internal_at());
    if (std::isnan(T)) {
        scale_energies(heat, swarm);
        return false;
    }
    const double left = energy - set_internal(T, mixture, swarm);
    swarm.scale(std::sqrt(std::max(0.0, left) / translational));  // 0 at T = 0, but for rounding
    return true;
}

}  // namespace corpuscle::gas
