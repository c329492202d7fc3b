// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/benchmark/collision_cases.hpp"

#include <cmath>
#include <functional>

#include "tests/support/gas/piston_box.hpp"
#include "tools/verify/exact/fast_piston.hpp"

namespace corpuscle::benchmark {

using namespace corpuscle::gas;

namespace {

/// A gas at rest behind a piston, and when to look at it.
struct PistonCase {
    SpeciesCard gas;
    Vec3 size;
    double temperature, pressure;         ///< before the piston moves                  [K], [Pa]
    std::function<double(double)> speed;  ///< of the piston over time                  [m/s]
    int bins;
    double bin;  ///< [s]
};

double error_of(const PistonCase& given, const Setting& setting, std::size_t n) {
    const double moles = given.pressure * given.size.prod() / (GAS_CONSTANT * given.temperature);
    const Mixture mixture = mixture_of({given.gas}, moles / static_cast<double>(n));
    PistonBox box(given.size, mixture, setting.model,
                  random_gas(n, given.size, mixture, {given.temperature}),
                  cell_edge(given.size.prod(), n, setting.particles_a_cell));
    const double M = given.gas.molar_mass;
    const double c_T = std::sqrt(GAS_CONSTANT * given.temperature / M);
    const int steps = static_cast<int>(std::ceil(given.bin / (setting.cfl * box.edge() / c_T)));
    const double dt = given.bin / steps;

    const double density = moles * M / given.size.prod();
    oracle::EulerTube exact(given.gas.A / (given.gas.A - GAS_CONSTANT), given.size.x(), 400,
                            [&](double) {
                                return oracle::Gas1D{density, 0.0, given.pressure};
                            });
    double squares = 0.0, time = 0.0;
    for (int b = 0; b < given.bins; ++b) {
        double wanted = 0.0;
        box.piston_impulse = 0.0;
        for (int i = 0; i < steps; ++i, time += dt) {
            box.step(dt, given.speed(time + 0.5 * dt));
            exact.advance(time + 0.5 * dt, given.speed);
            wanted += exact.piston_pressure() / steps;
        }
        const double area = given.size.y() * given.size.z();
        const double pressure = box.piston_impulse / (given.bin * area);
        squares += std::pow((pressure - wanted) / given.pressure, 2) / given.bins;
    }
    return std::sqrt(squares);
}

}  // namespace

double fast_piston_error(const Setting& setting, std::size_t n) {
    namespace piston = oracle::fast_piston;
    return error_of({{piston::MOLAR_MASS, piston::CP, 0.0, 0.0},
                     Vec3::Constant(piston::SIDE),
                     piston::TEMPERATURE,
                     piston::PRESSURE,
                     [](double t) { return piston::velocity(piston::START + t); },
                     40,
                     1e-4},
                    setting, n);
}

double compression_error(const Setting& setting, std::size_t n) {
    constexpr double SPEED = 200.0, STOPS = 0.1 / SPEED;
    return error_of({AIR,
                     {0.2, 0.1, 0.1},
                     300.0,
                     1e5,
                     [](double t) { return t < STOPS ? -SPEED : 0.0; },
                     20,
                     5e-5},
                    setting, n);
}

Mixing mixing_error(const Setting& setting, std::size_t n) {
    constexpr double T[] = {400.0, 280.0};
    constexpr int STEPS = 200, FROM = 100;
    const SpeciesCard nitrogen{0.028, 29.1, 0.0, 0.0};
    const Mixture mixture = mixture_of({HELIUM, nitrogen});
    const Vec3 size = Vec3::Constant(0.1);
    PistonBox box(size, mixture, setting.model, random_gas(n, size, mixture, {T[0], T[1]}),
                  cell_edge(size.prod(), n, setting.particles_a_cell));
    const double half = 0.5 * static_cast<double>(n) * mixture.moles_each();
    const double end = mixture_temperature(mixture.species(), std::vector<double>{half, half},
                                           Invariants(box.gas, mixture).energy);
    const double c_T = std::sqrt(GAS_CONSTANT * end / HELIUM.molar_mass);
    Mixing found{0.0, 0.0};
    double mean[2] = {};
    for (int i = 1; i <= STEPS; ++i) {
        box.step(setting.cfl * box.edge() / c_T);
        for (const int s : {0, 1}) {
            const double off = motion_temperature(box.gas, mixture, s) / end - 1.0;
            if (std::abs(off) > 0.01) found.step_to_1 = i + 1;
            if (i > FROM) mean[s] += off / (STEPS - FROM);
        }
    }
    found.error = std::sqrt(0.5 * (mean[0] * mean[0] + mean[1] * mean[1]));
    return found;
}

}  // namespace corpuscle::benchmark
