// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: behind a strong shock the gas has the pressure of Rankine and Hugoniot, with little overshoot.
#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/case_report.hpp"
#include "tests/support/gas/piston_box.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr std::size_t N = 100000, SLABS = 100;
constexpr double EDGE = 1.0 / 60.0,
                 SHOCK_SHARE = 1.0 / 6.0;  ///< of a cell; of it, between collisions
constexpr double END = 0.25;
constexpr double SPEED = 2.0;  ///< of the gas towards the wall, where c_T = sqrt(R T / M) = 1
constexpr double GAMMA = 1.4;
constexpr int RUNS = 4;

/// Adds 2/3 of the thermal energy per volume of each slab, over RUNS.
void add_pressure(const gas::Particles& all, std::array<double, SLABS>& pressure) {
    std::array<double, SLABS> m{}, mv{}, mvv{};
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto slab = std::min(SLABS - 1, static_cast<std::size_t>(all.x[i].x() * SLABS));
        m[slab] += 1.0;
        mv[slab] += all.v[i].x();
        mvv[slab] += all.v[i].squaredNorm();
    }
    for (std::size_t b = 0; b < SLABS; ++b)
        if (m[b] > 0.0) pressure[b] += (mvv[b] - mv[b] * mv[b] / m[b]) / 3.0 * SLABS / (N * RUNS);
}

}  // namespace

TEST_CASE("a shock of Mach 2.44 has its pressure, and overshoots by less than 6 %",
          "[gas][shock]") {
    const gas::Species diatomic({1.0, 3.5, 0.0, 0.0}, 1.0, "gas");
    const gas::Mixture mixture({diatomic}, 0.01 / N);
    std::array<double, SLABS> pressure{};
    for (int run = 0; run < RUNS; ++run) {
        gas::Particles start = gas::random_gas(N, {1.0, 0.1, 0.1}, mixture, {1.0}, 10 + run);
        for (Vec3& v : start.v) v.x() -= SPEED;
        gas::PistonBox box({1.0, 0.1, 0.1}, mixture, gas::CollisionModel::LIN, std::move(start),
                           EDGE * (1.0 + 1e-9), 10 + run);
        const int steps = static_cast<int>(std::ceil(END / (SHOCK_SHARE * EDGE)));
        for (int i = 0; i < steps; ++i) box.step(END / steps);
        add_pressure(box.gas, pressure);
    }
    // Mach number M of the shock in the gas that comes: M - 1/M = (gamma + 1) u / (2 c)
    const double c = std::sqrt(GAMMA), k = 0.5 * (GAMMA + 1.0) * SPEED / c;
    const double mach = 0.5 * (k + std::sqrt(k * k + 4.0)), front = (mach * c - SPEED) * END;
    const double exact = 1.0 + 2.0 * GAMMA / (GAMMA + 1.0) * (mach * mach - 1.0);
    double mean = 0.0, most = 0.0;
    int slabs = 0;
    for (std::size_t b = 4; b < SLABS; ++b) {  // off the wall
        const double x = (static_cast<double>(b) + 0.5) / SLABS;
        most = std::max(most, pressure[b] / exact);
        if (x > front - 3.0 * EDGE) continue;
        mean += pressure[b] / exact;
        ++slabs;
    }
    mean /= slabs;
    report("shock: pressure behind it, over the exact one", 1.0, mean);
    report("shock: most pressure, over the exact one", 1.0, most);
    CHECK(mean == Approx(1.0).epsilon(0.01));
    CHECK(most < 1.06);
}
