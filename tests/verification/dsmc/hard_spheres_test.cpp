// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the tests' hard spheres are hard spheres. What kinetic theory knows of them [Chapman & Cowling
// 1970, ch. 10; Bird 1994], n = density, l = 1 / (sqrt 2 n pi d²), c = sqrt(k T / m):
//
//     collisions of a particle    4 / sqrt(pi) · c / (sqrt 2 · l) a time
//     viscosity                   1.016 · 5/16 sqrt(2 pi) c l
//     self-diffusion              1.019 [D12]1 with m1 = m2, d1 = d2
//     diffusion of two gases      [D12]1 = 3/8 / (n d12²) sqrt(k T / (2 pi m12)), d12 = (d1 + d2) / 2,
//                                 m12 = m1 m2 / (m1 + m2); exact: some percent more
//
// Cells of a third of l and steps of a quarter of the time between collisions raise the viscosity by 1.6 %
// [Alexander, Garcia & Alder 1998; Hadjiconstantinou 2000].
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/support/case_report.hpp"
#include "tests/verification/dsmc/flows.hpp"
#include "tests/verification/dsmc/hard_spheres.hpp"
#include "tools/verify/statistics.hpp"

using namespace corpuscle;
using namespace corpuscle::dsmc;
using corpuscle::test::report;
using std::numbers::pi;

namespace {

constexpr double LENGTH = 30.0;  ///< mean free paths between the mirrors: half a wave
constexpr std::size_t N = 60000;
constexpr double DENSITY = N / LENGTH;

Plane column() {
    return {{LENGTH, 1.0}, {90, 1}, true};
}

/// rate / k² of a wave that dies away as exp(-rate t) from t = 6 to `end`: least squares of its logarithm
/// over that at t = 6, weighted by its square.
double decay(HardSpheres& gas, double dt, double end,
             const std::function<double(const Particle&)>& carried) {
    constexpr double SETTLED = 6.0;
    const double k = pi / LENGTH;
    double first = 0.0, wtt = 0.0, wta = 0.0;
    for (double t = 0.0; t < end; t += dt, gas.step(dt)) {
        if (t < SETTLED) continue;
        double a = 0.0;
        for (const Particle& p : gas.particles()) a += carried(p) * std::cos(k * p.x[0]);
        if (first == 0.0) first = a;
        const double w = a * a / (first * first), since = t - SETTLED;
        wtt += w * since * since;
        wta += w * since * std::log(a / first);
    }
    return -wta / wtt / (k * k);
}

/// Two gases side by side, x_0 = (1 + cos k x) / 2: D / (c l) of gas 0.
double diffusion(const Spheres& other, double dt, std::uint64_t seed) {
    HardSpheres gas(column(), {{1.0, 1.0}, other}, DENSITY, 1.0, seed);
    gas.fill(0, N, 0.0, LENGTH);
    for (Particle& p : gas.particles()) {
        if (gas.uniform() < 0.5 + 0.5 * std::cos(pi * p.x[0] / LENGTH)) continue;
        p.gas = 1;
        for (double& v : p.v) v /= std::sqrt(other.mass);
    }
    return decay(gas, dt, 50.0, [](const Particle& p) { return p.gas == 0 ? 1.0 : -1.0; });
}

/// [D12]1 / (c l).
double first_order(const Spheres& other) {
    const double d12 = 0.5 * (1.0 + other.diameter), m12 = other.mass / (1.0 + other.mass);
    return 0.375 * std::numbers::sqrt2 * pi / (d12 * d12) / std::sqrt(2.0 * pi * m12);
}

}  // namespace

TEST_CASE("hard spheres collide as often as kinetic theory says", "[dsmc]") {
    HardSpheres gas(column(), {{1.0, 1.0}}, DENSITY, 1.0, 1);
    gas.fill(0, N, 0.0, LENGTH);
    for (int i = 0; i < 10; ++i) gas.step(0.1);
    const std::size_t before = gas.collisions();
    for (int i = 0; i < 100; ++i) gas.step(0.1);
    const double rate = 2.0 * static_cast<double>(gas.collisions() - before) / N / 10.0;
    report("hard spheres: collisions of a particle, l / c", std::sqrt(8.0 / pi), rate);
    CHECK(rate == Approx(std::sqrt(8.0 / pi)).epsilon(0.01));
}

TEST_CASE("hard spheres have the viscosity of Chapman and Enskog", "[dsmc]") {
    constexpr double EXACT = 1.016, CELLS = 1.016, SPEED = 0.5;
    // the wave warms the gas by SPEED² / 6 in the end, half of it on average; the viscosity goes as sqrt(T)
    constexpr double WARMTH = 1.0 + SPEED * SPEED / 24.0;
    constexpr std::size_t MANY = 3 * N;
    HardSpheres gas(column(), {{1.0, 1.0}}, MANY / LENGTH, 1.0, 1);
    gas.fill(0, MANY, 0.0, LENGTH);
    for (Particle& p : gas.particles()) p.v[1] += SPEED * std::cos(pi * p.x[0] / LENGTH);
    const double nu = decay(gas, 0.15, 120.0, [](const Particle& p) { return p.v[1]; });
    const double expected = EXACT * CELLS * WARMTH * 5.0 / 16.0 * std::sqrt(2.0 * pi);
    report("hard spheres: viscosity / (c l)", expected, nu);
    CHECK(nu == Approx(expected).epsilon(0.025));  // chance: 1 %
}

TEST_CASE("hard spheres diffuse as Chapman and Enskog have it", "[dsmc]") {
    constexpr double EXACT = 1.019;
    const Spheres alike{1.0, 1.0}, helium{SlitFlow::HELIUM_MASS, SlitFlow::HELIUM_DIAMETER};
    const double own = diffusion(alike, 0.15, 1), of_two = diffusion(helium, 0.1, 1);
    report("hard spheres: self-diffusion / (c l)", EXACT * first_order(alike), own);
    report("hard spheres: diffusion of helium and air / (c l)", first_order(helium), of_two);
    CHECK(own == Approx(EXACT * first_order(alike)).epsilon(0.02));
    CHECK(of_two == Approx(EXACT * first_order(helium)).epsilon(0.03));
}

TEST_CASE("hard spheres of two gases that begin with one speed each come to Maxwell's", "[dsmc]") {
    const Spheres helium{SlitFlow::HELIUM_MASS, SlitFlow::HELIUM_DIAMETER};
    constexpr double REJECTED_IN_1_OF_100 = 1.63;
    HardSpheres gas(column(), {{1.0, 1.0}, helium}, DENSITY, 1.0, 1);
    gas.fill(0, N / 2, 0.0, LENGTH);
    gas.fill(1, N / 2, 0.0, LENGTH);
    for (Particle& p : gas.particles()) {
        const double norm = std::hypot(p.v[0], p.v[1], p.v[2]);
        for (double& v : p.v) v *= std::sqrt(3.0 / gas.mass(p)) / norm;
    }
    const auto distance = [&](int of) {
        std::vector<double> speeds;
        for (const Particle& p : gas.particles())
            if (p.gas == of) speeds.push_back(std::hypot(p.v[0], p.v[1], p.v[2]));
        const double a = of == 0 ? 1.0 : 1.0 / std::sqrt(helium.mass);
        return verify::kolmogorov_smirnov(
            speeds, [&](double speed) { return verify::maxwell_below(speed, a); });
    };
    CHECK(distance(0) > 10.0);
    for (int i = 0; i < 150; ++i) gas.step(0.1);
    report("hard spheres: Kolmogorov-Smirnov, air (1.63: 1 in 100)", 0.0, distance(0));
    report("hard spheres: Kolmogorov-Smirnov, helium", 0.0, distance(1));
    CHECK(distance(0) < REJECTED_IN_1_OF_100);
    CHECK(distance(1) < REJECTED_IN_1_OF_100);
}

TEST_CASE("hard spheres keep momentum and energy, and effuse through a slit", "[dsmc]") {
    // no collisions to speak of: n c / sqrt(2 pi) pass by area and time
    constexpr double SLIT = 0.25, TIME = 1.0;
    HardSpheres thin({{8.0, 4.0}, {2, 1}, false, 0.0, SLIT}, {{1.0, 1.0}}, N / 32.0, 1e6, 1);
    thin.fill(0, N, 0.0, 4.0);
    for (int i = 0; i < 20; ++i) thin.step(TIME / 20);
    const auto& all = thin.particles();
    const auto passed =
        std::count_if(all.begin(), all.end(), [](const Particle& p) { return p.x[0] > 4.0; });
    const double expected = N / 16.0 * SLIT * TIME / std::sqrt(2.0 * pi);
    report("hard spheres: through a slit", expected, static_cast<double>(passed));
    CHECK(static_cast<double>(passed) == Approx(expected).margin(3.0 * std::sqrt(expected)));

    HardSpheres gas({{LENGTH, 1.0}, {90, 1}, true}, {{1.0, 1.0}, {0.25, 0.5}}, DENSITY, 1.0, 1);
    gas.fill(0, N / 2, 0.0, LENGTH);
    gas.fill(1, N / 2, 0.0, LENGTH);
    const auto sums = [&] {
        std::array<double, 2> sum{};  // along y, where there are no mirrors; energy
        for (const Particle& p : gas.particles()) {
            sum[0] += gas.mass(p) * p.v[1];
            for (const double v : p.v) sum[1] += gas.mass(p) * v * v;
        }
        return sum;
    };
    const auto before = sums();
    for (int i = 0; i < 50; ++i) gas.step(0.15);
    const auto after = sums();
    CHECK(after[0] == Approx(before[0]).margin(1e-9 * N));
    CHECK(after[1] == Approx(before[1]).epsilon(1e-12));
}
