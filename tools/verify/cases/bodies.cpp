// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rigid bodies: a pendulum on a hinge, a plate on a slope, one that turns over.

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

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

/// A free body's spin along its principal axes, and how they lie.
struct Turn {
    Vec3 spin;
    Eigen::Vector4d axes;  ///< quaternion x y z w
};

/// Euler's equations I w' = (I w) x w, and q' = q (0, w) / 2.
Turn rate(const Turn& turn, const Vec3& inertia) {
    const Vec3& w = turn.spin;
    const Vec3 momentum = inertia.cwiseProduct(w);
    const Eigen::Quaterniond q(turn.axes);
    const Eigen::Quaterniond by(0.0, w[0], w[1], w[2]);
    return {momentum.cross(w).cwiseQuotient(inertia), 0.5 * (q * by).coeffs()};
}

/// One step of Runge and Kutta's rule of fourth order.
void advance(Turn& turn, const Vec3& inertia, double dt) {
    const auto moved = [&](const Turn& k, double h) {
        return Turn{turn.spin + h * k.spin, turn.axes + h * k.axes};
    };
    const Turn a = rate(turn, inertia), b = rate(moved(a, 0.5 * dt), inertia),
               c = rate(moved(b, 0.5 * dt), inertia), d = rate(moved(c, dt), inertia);
    turn.spin += dt / 6.0 * (a.spin + 2.0 * b.spin + 2.0 * c.spin + d.spin);
    turn.axes += dt / 6.0 * (a.axes + 2.0 * b.axes + 2.0 * c.axes + d.axes);
}

}  // namespace

/// A plate of three quads of 0.1 m, on a hinge along the side of one of them, from rest at the
/// level.
Findings pendulum(const Runs& runs) {
    constexpr double QUARTER = 1.854074677301372;  // K(sin 45°)
    double moment = 0.0, inertia = 0.0;
    for (const double x : {0.0, 0.1, 0.2, 0.3}) {
        const double m = 2000.0 * 0.002 * 0.1 * 0.1 * (x == 0.0 || x == 0.3 ? 0.5 : 1.0);
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

/// A plate of 0.1 x 0.2 m, a quarter of its mass at each corner, spins about its middle axis.
Findings tennis_racket(const Runs& runs) {
    const Vec3 corner(0.05, 0.1, 0.0);
    const Vec3 inertia(corner[1] * corner[1], corner[0] * corner[0], corner.squaredNorm());
    constexpr int STEPS = 100;  // a sample
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto time = run.time(), kinetic = run.read("/history/energy/kinetic");
        const auto x = run.vectors("/history/node/3/coordinates");
        Turn turn{Vec3(50.0, 0.5, 0.5), Eigen::Quaterniond::Identity().coeffs()};
        double apart = 0.0, change = 0.0;
        for (std::size_t i = 1; i < time.size(); ++i) {
            const double dt = (time[i] - time[i - 1]) / STEPS;
            for (int k = 0; k < STEPS; ++k) advance(turn, inertia, dt);
            const Vec3 exact = Eigen::Quaterniond(turn.axes).normalized() * corner;
            apart = std::max(apart, (x[i] - exact).norm() / corner.norm());
            change = std::max(change, std::abs(kinetic[i] / kinetic[0] - 1.0));
        }
        return std::map<std::string, double>{{"corner", apart}, {"energy", change}};
    });
}

}  // namespace corpuscle::verify
