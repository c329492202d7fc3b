// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Membranes: waves across and along a strip that is held at its ends; a sheet that is damped.

#include <cmath>

#include "solver/base/error.hpp"
#include "tools/verify/case_list.hpp"

namespace corpuscle::verify {
namespace {

constexpr double STRIP = 1.0, STRIP_E = 3e8, STRIP_RHO = 800.0;

/// When the node of the history comes back to where it was, linear between samples.           [s]
double half_period(const MeasuredRun& run, int axis) {
    const std::string node = "/history/node/" + run.names("/history/node").front();
    const auto time = run.time();
    const auto x = run.vectors(node + "/coordinates");
    for (std::size_t i = 2; i < time.size(); ++i) {
        const double before = x[i - 1][axis] - x[0][axis], after = x[i][axis] - x[0][axis];
        if (before > 0.0 && after <= 0.0)
            return time[i - 1] + (time[i] - time[i - 1]) * before / (before - after);
    }
    throw SystemError("the strip has not come back");
}

Findings against(const Runs& runs, int axis, double speed) {
    return by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{
            {"half_period", half_period(run, axis) * speed / STRIP - 1.0}};
    });
}

}  // namespace

/// Stretched to 1.01 times its reference length: c² = force / mass, both by length, of what is
/// stretched.
Findings taut_string(const Runs& runs) {
    constexpr double STRETCH = 1.01, GREEN = 0.5 * (STRETCH * STRETCH - 1.0);
    return against(runs, 2, std::sqrt(STRIP_E * GREEN * STRETCH * STRETCH / STRIP_RHO));
}

Findings plane_wave(const Runs& runs) {
    return against(runs, 0, std::sqrt(STRIP_E / STRIP_RHO));
}

/// Warp and weft are moved across each other: c² = G / rho.
Findings shear_wave(const Runs& runs) {
    constexpr double G = 4e6;
    return against(runs, 1, std::sqrt(G / STRIP_RHO));
}

/// 10 m/s along each axis, d = 50 / s.
Findings damped_sheet(const Runs& runs) {
    constexpr double MASS = STRIP_RHO * 0.3e-3 * 0.1 * 0.1, DAMPING = 50.0;
    constexpr double FIRST = 0.5 * MASS * 300.0;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double left = FIRST * std::exp(-2.0 * DAMPING * run.time().back());
        return std::map<std::string, double>{
            {"damping", run.last("/history/energy/damping") / (FIRST - left) - 1.0},
            {"kinetic", run.last("/history/energy/kinetic") / left - 1.0}};
    });
}

}  // namespace corpuscle::verify
