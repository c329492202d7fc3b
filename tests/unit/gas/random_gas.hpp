// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gas/particles.hpp"
#include "gas/thermo/species.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

inline const SpeciesCard AIR{0.028, 28.0, 0.0, 0.0};
inline const SpeciesCard HELIUM{0.004, 20.79, 0.0, 0.0};
inline const SpeciesCard CARBON_DIOXIDE{0.044, 22.26, 59.81e-3, -35.01e-6};

inline Mixture mixture_of(const std::vector<SpeciesCard>& cards, double moles_each = 1e-6) {
    std::vector<Species> species;
    for (const SpeciesCard& card : cards) species.emplace_back(card, GAS_CONSTANT, "gas");
    return {species, moles_each};
}

/// n particles in the box 0..size, species in turn, each species at its own temperature T[s].
inline Particles random_gas(std::size_t n, const Vec3& size, const Mixture& mixture,
                            const std::vector<double>& T, std::uint64_t seed = 1) {
    Particles gas;
    for (std::size_t i = 0; i < n; ++i) {
        Random draw(seed, Stream::INITIAL, 0, i);
        const auto s = static_cast<std::int32_t>(i % T.size());
        const double spread =
            std::sqrt(2.0 * mixture.half_heat() * T[s] / mixture.particle_mass(s));
        Vec3 at, v;  // drawn in the same order with every compiler
        for (int k = 2; k >= 0; --k) at[k] = size[k] * draw.uniform();
        for (int k = 2; k >= 0; --k) v[k] = spread * draw.normal();
        gas.add(at, v, mixture.particle_internal(s)(T[s]), s, static_cast<std::int32_t>(i));
    }
    return gas;
}

/// What collisions must keep.
struct Invariants {
    double mass = 0.0, energy = 0.0;
    Vec3 momentum = Vec3::Zero(), spin = Vec3::Zero();

    Invariants(const Particles& gas, const Mixture& mixture) {
        for (std::size_t i = 0; i < gas.size(); ++i) {
            const double m = mixture.particle_mass(gas.species[i]);
            mass += m;
            energy += 0.5 * m * gas.v[i].squaredNorm() + gas.e[i];
            momentum += m * gas.v[i];
            spin += m * gas.x[i].cross(gas.v[i]);
        }
    }
};

/// Temperature of a species' motion, sum m v² / (3 n k), for a gas at rest.
inline double motion_temperature(const Particles& gas, const Mixture& mixture, std::int32_t s) {
    double energy = 0.0, n = 0.0;
    for (std::size_t i = 0; i < gas.size(); ++i) {
        if (gas.species[i] != s) continue;
        energy += 0.5 * mixture.particle_mass(s) * gas.v[i].squaredNorm();
        n += 1.0;
    }
    return energy / (3.0 * n * mixture.half_heat());
}

/// Free flight in the box 0..size with mirror walls.
inline void drift_in_box(double dt, const Vec3& size, Particles& gas) {
    for (std::size_t i = 0; i < gas.size(); ++i) {
        gas.x[i] += dt * gas.v[i];
        for (int a = 0; a < 3; ++a) {
            double& x = gas.x[i][a];
            while (x < 0.0 || x > size[a]) {
                x = x < 0.0 ? -x : 2.0 * size[a] - x;
                gas.v[i][a] = -gas.v[i][a];
            }
        }
    }
}

}  // namespace corpuscle::gas
