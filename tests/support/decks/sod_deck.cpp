// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/decks/sod_deck.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <stdexcept>

#include "tests/support/decks/shock_tube_deck.hpp"
#include "tools/verify/exact/exact_riemann.hpp"

namespace corpuscle::test {

namespace {

constexpr std::size_t SLABS = 100;
constexpr double P = 1e5, T = 300.0;       ///< of the left                      [Pa], [K]
constexpr double CP = 3.5 * GAS_CONSTANT;  ///< gamma = 1.4                      [J/(mol K)]
constexpr double END = 0.2;                ///< length over c_T                  [-]

struct Profile {
    std::array<double, SLABS> density{}, pressure{};

    void add(const Profile& other, double weight) {
        for (std::size_t b = 0; b < SLABS; ++b) {
            density[b] += weight * other.density[b];
            pressure[b] += weight * other.pressure[b];
        }
    }
};

/// rho and p = (sum m v² - (sum m v_x)² / sum m) / 3 V of each slab of the last frame, over the
/// left's.
Profile measured(const DeckRun& run) {
    const std::string frame = "/frames/00001/particles/";
    const auto x = run.read(frame + "position"), v = run.read(frame + "velocity"),
               mass = run.read(frame + "mass");
    std::array<double, SLABS> m{}, mv{}, mvv{};
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const auto slab = static_cast<std::size_t>(std::max(0.0, x[3 * i] * SLABS));
        const std::size_t b = std::min(SLABS - 1, slab);
        const Vec3 velocity(v[3 * i], v[3 * i + 1], v[3 * i + 2]);
        m[b] += mass[i];
        mv[b] += mass[i] * velocity.x();
        mvv[b] += mass[i] * velocity.squaredNorm();
    }
    Profile profile;
    constexpr double VOLUME = 0.01 / SLABS;
    for (std::size_t b = 0; b < SLABS; ++b) {
        profile.density[b] = m[b] / VOLUME / air::density(P, T);
        profile.pressure[b] = (mvv[b] - mv[b] * mv[b] / m[b]) / (3.0 * VOLUME) / P;
    }
    return profile;
}

/// `t` after the opening, in the middles of the slabs.
Profile exact(double t) {
    const double c_T = std::sqrt(GAS_CONSTANT * T / air::MOLAR_MASS);
    Profile profile;
    for (std::size_t b = 0; b < SLABS; ++b) {
        const double x = (static_cast<double>(b) + 0.5) / SLABS - 0.5;
        const oracle::Gas1D gas =
            oracle::exact_riemann(1.4, {1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, x / (t * c_T));
        profile.density[b] = gas.density;
        profile.pressure[b] = gas.pressure;
    }
    return profile;
}

double distance(const std::array<double, SLABS>& a, const std::array<double, SLABS>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < SLABS; ++i) sum += std::abs(a[i] - b[i]) / SLABS;
    return sum;
}

}  // namespace

SodDeckError sod_deck_error(int particles, int runs) {
    const double c_T = std::sqrt(GAS_CONSTANT * T / air::MOLAR_MASS);
    shock_tube::Tube tube{P, T, 0.1 * P, 0.8 * T, particles, END / c_T};
    tube.molar_cp = CP;
    tube.shows_particles = true;
    tube.frames = 0.0;
    tube.sample = 1e-7;  // a row a step: the valve opens with the first step from OPENS on
    const std::string deck = shock_tube::deck(tube, shock_tube::box(false));
    std::array<Profile, 2> half;
    Profile mean, truth;
    for (int r = 0; r < runs; ++r) {
        const DeckRun run(fmt::format("sod_{}", r + 1), deck, fmt::format("--seed {}", r + 1));
        if (run.status() != 0) throw std::runtime_error("the program has not run Sod's tube");
        const auto time = run.time();
        const auto opened = std::lower_bound(time.begin(), time.end(), shock_tube::OPENS);
        const Profile found = measured(run);
        half[r % 2].add(found, 2.0 / runs);
        mean.add(found, 1.0 / runs);
        truth.add(exact(time.back() - *opened), 1.0 / runs);
    }
    return {distance(mean.density, truth.density), distance(mean.pressure, truth.pressure),
            0.5 * distance(half[0].density, half[1].density),
            0.5 * distance(half[0].pressure, half[1].pressure)};
}

}  // namespace corpuscle::test
