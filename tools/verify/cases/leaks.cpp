// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Porous cloth under pressure that is not the same everywhere, against 1-D Euler equations.

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/curve.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/euler_1d.hpp"

namespace corpuscle::verify {
namespace {

constexpr std::size_t RINGS = 8;  ///< of porous wall, from x = 0 on
constexpr double RING = 0.1, TUBE = 1.0, SECTION_OF_TUBE = 0.01, PERIMETER = 0.4;  ///< [m], [m²]
constexpr double RUNS_AT = 60.0;                                                   ///< piston [m/s]
using OfRings = std::array<double, RINGS>;

/// Velocity at which the cloth leaks.                                                        [m/s]
double leak_velocity(double p) {
    constexpr double FLC = 0.1, FAC = 80.0, ATM = 101325.0, RISE = 50000.0;
    return FLC * FAC * std::clamp((p - ATM) / RISE, 0.0, 1.0);
}

/// Of the gas at x, per time.                                                                [1/s]
double leaks_at(double x, const oracle::Gas1D& gas) {
    return x < RING * RINGS ? leak_velocity(gas.pressure) * PERIMETER / SECTION_OF_TUBE : 0.0;
}

/// Rates at which rings leak: cells count as far as they lie in a ring.                     [kg/s]
OfRings ring_rates(const oracle::EulerTube& tube) {
    const auto gas = tube.gas();
    const double width = tube.length() / static_cast<double>(gas.size());
    OfRings rate{};
    for (std::size_t i = 0; i < gas.size(); ++i)
        for (std::size_t r = 0; r < RINGS; ++r) {
            const double from = static_cast<double>(i) * width,
                         ring = static_cast<double>(r) * RING;
            const double inside = std::min(from + width, ring + RING) - std::max(from, ring);
            if (inside <= 0.0) continue;
            rate[r] += gas[i].density * SECTION_OF_TUBE * inside * leaks_at(tube.centre(i), gas[i]);
        }
    return rate;
}

struct LeakHistory {
    std::vector<OfRings> out;  ///< of each ring until each sample                          [kg]
    OfRings arrives{};         ///< of the front at each ring, before a hundredth has left    [s]
};

/// What rings have let out at `time`, by Euler's equations.
LeakHistory exact_leaks(const std::vector<double>& time, double gamma, const oracle::Gas1D& rest) {
    oracle::EulerTube tube(gamma, TUBE, 400, [&](double) { return rest; });
    tube.leak(leaks_at);
    LeakHistory history;
    history.out.push_back({});
    OfRings before = ring_rates(tube);
    for (std::size_t i = 1; i < time.size(); ++i) {
        constexpr int PARTS = 20;
        OfRings out = history.out.back();
        for (int k = 1; k <= PARTS; ++k) {
            tube.advance(time[i - 1] + (time[i] - time[i - 1]) * k / PARTS,
                         [](double) { return -RUNS_AT; });
            const OfRings now = ring_rates(tube);
            for (std::size_t r = 0; r < RINGS; ++r)
                out[r] += 0.5 * (before[r] + now[r]) * (time[i] - time[i - 1]) / PARTS;
            before = now;
        }
        history.out.push_back(out);
    }
    for (std::size_t r = 0; r < RINGS; ++r)
        for (std::size_t i = 0; i < time.size(); ++i)
            if (history.out[i][r] < 0.01 * history.out.back()[r]) history.arrives[r] = time[i];
    return history;
}

double sum_of(const OfRings& rings) {
    double sum = 0.0;
    for (const double of : rings) sum += of;
    return sum;
}

}  // namespace

/// A piston drives a shock along a tube whose cloth leaks as the pressure at it says; what has left
/// ring by ring.
Findings porous_tube(const Runs& runs) {
    constexpr double P0 = 101325.0, T0 = 300.0, M = 0.028, CP = 28.0;
    const oracle::Gas1D rest{P0 * M / (GAS_CONSTANT * T0), 0.0, P0};
    const auto time = runs.front().time();
    const LeakHistory exact = exact_leaks(time, CP / (CP - GAS_CONSTANT), rest);
    const OfRings& last = exact.out.back();
    return by_run(runs, [&](const MeasuredRun& run) {
        double early = 0.0, rings = 0.0, worst = 0.0;
        std::vector<double> all(time.size(), 0.0);
        for (std::size_t r = 0; r < RINGS; ++r) {
            const std::string ring = "/history/airbag/1/part/" + std::to_string(11 + r) + "/";
            const Curve out{0, run.time(), run.read(ring + "mass_out")};
            early += out(0.9 * exact.arrives[r]);
            rings += std::abs(out.y.back() - last[r]);
            for (std::size_t i = 0; i < time.size(); ++i) all[i] += out(time[i]);
        }
        for (std::size_t i = 0; i < time.size(); ++i)
            worst = std::max(worst, std::abs(all[i] - sum_of(exact.out[i])));
        return std::map<std::string, double>{{"early", early / sum_of(last)},
                                             {"rings", rings / sum_of(last)},
                                             {"mass", worst / sum_of(last)}};
    });
}

}  // namespace corpuscle::verify
