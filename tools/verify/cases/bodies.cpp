// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rigid bodies: a pendulum on a hinge, a plate on a slope.

#include <cmath>

#include "solver/base/error.hpp"
#include "tools/verify/case_list.hpp"

namespace corpuscle::verify {
namespace {

constexpr double GRAVITY = 9.81;

/// When a coordinate falls through 0, linear between samples.                                [s]
double crossing(const std::vector<double>& time, const std::vector<Vec3>& x, int axis) {
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double before = x[i - 1][axis], after = x[i][axis];
        if (before > 0.0 && after <= 0.0)
            return time[i - 1] + (time[i] - time[i - 1]) * before / (before - after);
    }
    throw SystemError("pendulum: it has not come to the bottom");
}

}  // namespace

/// A plate of three quads of 0.1 m, on a hinge along the side of one of them, from rest at the
/// level.
Findings pendulum(const Runs& runs) {
    constexpr double QUARTER = 1.854074677301372;  // K(sin 45°)
    double mass = 0.0, moment = 0.0, inertia = 0.0;
    for (const double x : {0.0, 0.1, 0.2, 0.3}) {
        const double m = 2000.0 * 0.002 * 0.1 * 0.1 * (x == 0.0 || x == 0.3 ? 0.5 : 1.0);
        mass += m;
        moment += m * x;
        inertia += m * x * x;
    }
    const double quarter = QUARTER / std::sqrt(GRAVITY * moment / inertia);
    return by_run(runs, [&](const MeasuredRun& run) {
        const double bottom =
            crossing(run.time(), run.vectors("/history/rigid_body/2/position"), 0);
        const double kinetic = run.at("/history/energy/kinetic", bottom);
        return std::map<std::string, double>{{"quarter", bottom / quarter - 1.0},
                                             {"energy", kinetic / (GRAVITY * moment) - 1.0}};
    });
}

/// Down a slope of 30° with Coulomb's friction.
Findings sliding_block(const Runs& runs) {
    constexpr double MASS = 2000.0 * 0.002 * 0.1 * 0.1;
    const double along = 0.5 * GRAVITY, across = std::sqrt(0.75) * GRAVITY;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double mu = run.parameter("MU"), t = run.time().back();
        const double way = 0.5 * (along - mu * across) * t * t;
        const auto x = run.vectors("/history/rigid_body/1/position");
        return std::map<std::string, double>{
            {"way", (x.back()[0] - x.front()[0]) / way - 1.0},
            {"friction", run.last("/history/energy/friction") / (mu * MASS * across * way) - 1.0}};
    });
}

}  // namespace corpuscle::verify
