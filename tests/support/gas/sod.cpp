// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/gas/sod.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <ctime>
#include <utility>

#include "tests/support/gas/piston_box.hpp"
#include "tools/verify/exact/exact_riemann.hpp"

namespace corpuscle::oracle {

namespace {

constexpr std::size_t BINS = 100;
constexpr double END = 0.2;
constexpr double GAMMA = 1.4;
constexpr double AREA = 0.01;
constexpr double MASS = AREA * 0.5 * (1.0 + 0.125);
const Gas1D LEFT{1.0, 0.0, 1.0}, RIGHT{0.125, 0.0, 0.1};

struct Profile {
    std::array<double, BINS> density{}, pressure{};
};

gas::Particles start(std::size_t n, const gas::Mixture& mixture, std::uint64_t seed) {
    gas::Particles all = gas::random_gas(n, {1.0, 0.1, 0.1}, mixture, {1.0}, seed);
    const double colder = RIGHT.pressure / RIGHT.density;
    for (std::size_t i = 0; i < n; ++i) {
        const bool is_left = i < n * 8 / 9;
        all.x[i].x() = 0.5 * all.x[i].x() + (is_left ? 0.0 : 0.5);
        if (is_left) continue;
        all.v[i] *= std::sqrt(colder);
        all.e[i] *= colder;
    }
    return all;
}

/// Adds rho and p = (sum m v² - (sum m v_x)² / sum m) / 3 V of each slab, times `weight`.
void add(const gas::Particles& all, double mass, double weight, Profile& to) {
    std::array<double, BINS> m{}, mv{}, mvv{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto slab = static_cast<std::size_t>(all.x[i].x() * BINS);
        const std::size_t b = std::min(BINS - 1, slab);
        const double each = mass * BINS / AREA;
        m[b] += each;
        mv[b] += each * all.v[i].x();
        mvv[b] += each * all.v[i].squaredNorm();
    }
    for (std::size_t b = 0; b < BINS; ++b) {
        to.density[b] += weight * m[b];
        to.pressure[b] += weight * (mvv[b] - mv[b] * mv[b] / m[b]) / 3.0;
    }
}

}  // namespace

SodError sod_error(const SodRun& run, int runs) {
    const gas::Species diatomic({1.0, 3.5, 0.0, 0.0}, 1.0, "gas");
    const gas::Mixture mixture({diatomic}, MASS / static_cast<double>(run.particles));
    const auto steps = static_cast<std::size_t>(std::ceil(END / (run.cfl * run.edge)));
    SodError error{0.0, 0.0, 0.0, 0.0, steps, 0.0};
    std::array<Profile, 2> half;
    for (int r = 0; r < runs; ++r) {
        const auto seed = static_cast<std::uint64_t>(10 + r);
        gas::PistonBox box({1.0, 0.1, 0.1}, mixture, run.model, start(run.particles, mixture, seed),
                           run.edge * (1.0 + 1e-9), seed, run.mean_free_path);
        const std::clock_t began = std::clock();
        for (std::size_t i = 0; i < steps; ++i) box.step(END / static_cast<double>(steps));
        error.cpu_seconds += static_cast<double>(std::clock() - began) /
                             (CLOCKS_PER_SEC * static_cast<double>(runs));
        add(box.gas, mixture.particle_mass(0), 2.0 / runs, half[r % 2]);
    }
    for (std::size_t b = 0; b < BINS; ++b) {
        const double x = (static_cast<double>(b) + 0.5) / BINS - 0.5;
        const Gas1D exact = exact_riemann(GAMMA, LEFT, RIGHT, x / END);
        const auto [rho_a, rho_b] = std::pair(half[0].density[b], half[1].density[b]);
        const auto [p_a, p_b] = std::pair(half[0].pressure[b], half[1].pressure[b]);
        error.density += std::abs(0.5 * (rho_a + rho_b) - exact.density) / BINS;
        error.pressure += std::abs(0.5 * (p_a + p_b) - exact.pressure) / BINS;
        error.density_noise += 0.5 * std::abs(rho_a - rho_b) / BINS;
        error.pressure_noise += 0.5 * std::abs(p_a - p_b) / BINS;
    }
    return error;
}

}  // namespace corpuscle::oracle
