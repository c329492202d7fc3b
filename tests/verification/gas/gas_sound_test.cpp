// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: heat wanders in LIN with alpha = 0.17 c_T h and sound of a wave of 16 cells fades with Gamma = 0.13 c_T h,
// h the edge of cells that hold 30 particles: more by heat than by viscosity. Of gas at rest in a box of mirrors, by what
// chance makes of its slowest waves: the autocorrelations of longitudinal momentum and of entropy are
//
//     exp(-Gamma k² t / 2) cos(c k t),   exp(-alpha k² t),   k = pi / L,   c = sqrt(gamma R T / M),
//     Gamma = 4/3 nu + (gamma - 1) alpha                                       [Landau & Placzek 1934]
#include <catch2/catch.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/case_report.hpp"
#include "tests/support/gas/air.hpp"
#include "tests/support/gas/piston_box.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;
using namespace corpuscle::test;

namespace {

constexpr double T_REST = 300.0, CELL_EDGE = 0.025;  ///< [K], of a cell [m]
constexpr double IN_A_CELL = 30.0,
                 CROSSED = 1.0 / 8.0;  ///< particles, c_T dt / h, as bags have them
constexpr int CELLS = 8;               ///< along each edge of the box
constexpr int EVERY = 4;               ///< steps that a sample of the waves stands for
constexpr double BOX_EDGE = CELLS * CELL_EDGE;
constexpr double WAVE_NUMBER = std::numbers::pi / BOX_EDGE;

const double C_T = std::sqrt(GAS_CONSTANT * T_REST / air::MOLAR_MASS);
const double DT = CROSSED * CELL_EDGE / C_T;

using Signal = std::vector<double>;

/// What waves along the three axes do, sample by sample.
struct Waves {
    std::array<Signal, 3> momentum, entropy;
};

Waves watch(int steps, std::uint64_t seed) {
    const Mixture mixture = mixture_of({AIR});
    const auto n = static_cast<std::size_t>(IN_A_CELL * CELLS * CELLS * CELLS);
    const Vec3 box_size = Vec3::Constant(BOX_EDGE);
    PistonBox box(box_size, mixture, CollisionModel::LIN,
                  random_gas(n, box_size, mixture, {T_REST}, seed), CELL_EDGE * (1.0 + 1e-9), seed);
    const double mass = mixture.particle_mass(0),
                 enthalpy = air::MOLAR_CP / air::MOLAR_MASS * T_REST;
    Waves waves;
    for (int step = 0; step < steps; ++step) {
        box.step(DT);
        if (step % EVERY != 0) continue;
        Vec3 momentum = Vec3::Zero(), entropy = Vec3::Zero();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec3& v = box.gas.v[i];
            const double beyond = 0.5 * v.squaredNorm() + box.gas.e[i] / mass - enthalpy;
            for (int a = 0; a < 3; ++a) {
                const double phase = WAVE_NUMBER * box.gas.x[i][a];
                momentum[a] += v[a] * std::sin(phase);
                entropy[a] += beyond * std::cos(phase);
            }
        }
        for (int a = 0; a < 3; ++a) {
            waves.momentum[a].push_back(momentum[a]);
            waves.entropy[a].push_back(entropy[a]);
        }
    }
    return waves;
}

/// Autocorrelation of all signals together at a lag in samples, over that at none.
double correlation(const std::array<Signal, 3>& signals, int lag) {
    double at_lag = 0.0, at_none = 0.0;
    for (const Signal& s : signals)
        for (std::size_t i = 0; i + static_cast<std::size_t>(lag) < s.size(); ++i) {
            at_lag += s[i] * s[i + static_cast<std::size_t>(lag)];
            at_none += 0.5 * (s[i] * s[i] + s[i + lag] * s[i + lag]);
        }
    return at_lag / at_none;
}

void check_decay(int steps, double within) {
    constexpr double OF_HEAT = 0.17, OF_SOUND = 0.13;
    const Waves waves = watch(steps, 1);
    const double unit = C_T * CELL_EDGE * WAVE_NUMBER * WAVE_NUMBER;  // [1/s]
    const double c = std::sqrt(air::GAMMA) * C_T;
    const double between = EVERY * DT;  // samples [s]
    const int period =
        static_cast<int>(std::lround(2.0 * std::numbers::pi / (WAVE_NUMBER * c * between)));
    const int fold = static_cast<int>(std::lround(0.5 / (OF_HEAT * unit * between)));
    const double alpha = -std::log(correlation(waves.entropy, fold)) / (fold * between * unit);
    const double gamma =
        -2.0 * std::log(correlation(waves.momentum, period)) / (period * between * unit);
    report("LIN: heat, alpha / (c_T h)", OF_HEAT, alpha);
    report("LIN: sound of 16 cells, Gamma / (c_T h)", OF_SOUND, gamma);
    CHECK(alpha == Approx(OF_HEAT).epsilon(within));
    CHECK(gamma == Approx(OF_SOUND).epsilon(within));
}

}  // namespace

TEST_CASE("sound fades in gas by its cells, more by heat than by viscosity", "[gas][sound]") {
    check_decay(30'000, 0.4);
}

TEST_CASE("what sound loses, and heat: ten times as long", "[.long][sound]") {
    check_decay(300'000, 0.12);
}
