// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: the viscosity of LIN is a share of its cells, nu = 0.035 c_T h, a tenth of that of random pairs and
// thousands of times that of air; 10 % less where the wave is 20 cells long. Gas that slides along itself between
// mirrors, at rest else, without end sideways:
//
//     u_y = U cos(k x) exp(-nu k² t),   k = pi / L                                       [Navier and Stokes]
//
// No deck makes such a flow: walls are mirrors, they drag nothing along.
#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <vector>

#include "gas/collisions/collide.hpp"
#include "tests/support/case_report.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;
using namespace corpuscle::test;

namespace {

constexpr double LENGTH = 0.5, WIDTH = 0.2;         ///< [m]
constexpr double T_SHEAR = 300.0;                   ///< [K]
constexpr double A_CELL = 30.0, SHARE = 1.0 / 8.0;  ///< particles, c_T dt / h, as bags have them
constexpr double FASTEST = 0.5;                     ///< U / c_T

/// Free flight between mirrors at x = 0 and LENGTH; what leaves sideways comes in on the other side.
void fly(double dt, Particles& gas) {
    for (std::size_t i = 0; i < gas.size(); ++i) {
        Vec3& x = gas.x[i];
        x += dt * gas.v[i];
        while (x.x() < 0.0 || x.x() > LENGTH) {
            x.x() = x.x() < 0.0 ? -x.x() : 2.0 * LENGTH - x.x();
            gas.v[i].x() = -gas.v[i].x();
        }
        for (const int a : {1, 2}) x[a] -= WIDTH * std::floor(x[a] / WIDTH);
    }
}

/// The wave's amplitude at the start and after each step.
std::vector<double> decay(CollisionModel model, double h, int steps, std::uint64_t seed) {
    const Mixture mixture = mixture_of({AIR});
    const Vec3 size(LENGTH, WIDTH, WIDTH);
    const double c_T = std::sqrt(GAS_CONSTANT * T_SHEAR / AIR.molar_mass);
    const double k = std::numbers::pi / LENGTH;
    const auto n = static_cast<std::size_t>(A_CELL * size.prod() / (h * h * h));
    Particles gas = random_gas(n, size, mixture, {T_SHEAR}, seed);
    for (std::size_t i = 0; i < n; ++i) gas.v[i].y() += FASTEST * c_T * std::cos(k * gas.x[i].x());
    Collider collider(mixture.species(), mixture.moles_each(), seed, model);
    const Grid cells =
        Grid::over(Vec3::Zero(), size - Vec3::Constant(1e-9), h * (1.0 + 1e-9), 100000);
    std::vector<double> amplitude;
    for (int step = 0; step <= steps; ++step) {
        double sum = 0.0;
        for (std::size_t i = 0; i < n; ++i) sum += gas.v[i].y() * std::cos(k * gas.x[i].x());
        amplitude.push_back(2.0 * sum / static_cast<double>(n));
        collider.find_groups(cells, {}, gas);
        collider.collide(static_cast<std::uint64_t>(step), SHARE * h / c_T, 1.0, gas);
        fly(SHARE * h / c_T, gas);
    }
    return amplitude;
}

/// nu / (c_T h) of gas in cells of h: slope of ln of the seeds' mean amplitude over `span` / c_T.
double viscosity(CollisionModel model, double h, double span, int seeds) {
    const int steps = static_cast<int>(span / (SHARE * h));
    std::vector<double> amplitude(static_cast<std::size_t>(steps) + 1, 0.0);
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto one = decay(model, h, steps, static_cast<std::uint64_t>(seed));
        for (std::size_t s = 0; s < one.size(); ++s) amplitude[s] += one[s] / seeds;
    }
    double st = 0.0, sa = 0.0, stt = 0.0, sta = 0.0, count = 0.0;
    for (const double a : amplitude) {
        const double t = count * SHARE * h;  // times c_T
        st += t;
        sa += std::log(a);
        stt += t * t;
        sta += t * std::log(a);
        count += 1.0;
    }
    const double rate = -(count * sta - st * sa) / (count * stt - st * st);
    return rate * std::pow(LENGTH / std::numbers::pi, 2) / h;
}

}  // namespace

TEST_CASE("the viscosity of gas is a share of its cells, small by LIN", "[gas][shear]") {
    constexpr double LONG_WAVE = 0.035, LIN_20_CELLS = 0.032, PAIRS_20_CELLS = 0.34;
    const double coarse = viscosity(CollisionModel::LIN, 0.05, 10.0, 4),
                 fine = viscosity(CollisionModel::LIN, 0.025, 10.0, 2),
                 pairs = viscosity(CollisionModel::PAIRS, 0.05, 3.0, 4);
    report("LIN, cells of 50 mm: nu / (c_T h)", LIN_20_CELLS, coarse);
    report("LIN, cells of 25 mm: nu / (c_T h)", LONG_WAVE, fine);
    report("random pairs, cells of 50 mm: nu / (c_T h)", PAIRS_20_CELLS, pairs);
    const double c_T = std::sqrt(GAS_CONSTANT * T_SHEAR / AIR.molar_mass);
    constexpr double OF_AIR = 1.57e-5,
                     DRIVER_BAG = 0.026;  // [m^2/s] at 300 K; h of 1e5 in 60 l  [m]
    report("LIN in a driver bag: viscosity over that of air", 1.0,
           fine * c_T * DRIVER_BAG / OF_AIR);
    CHECK(coarse == Approx(LIN_20_CELLS).epsilon(0.15));
    CHECK(fine == Approx(LONG_WAVE).epsilon(0.15));
    CHECK(pairs == Approx(PAIRS_20_CELLS).epsilon(0.15));
}
