// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: what a ball feels that falls on a taut membrane does not depend on the mesh.

#include <catch2/catch.hpp>

#include <cmath>
#include <deque>

#include "tests/support/geometry/cloth.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

constexpr double SPEED = 3.0;  ///< of the ball  [m/s]

struct Rebound {
    double speed = NaN;       ///< upwards, at the end                                 [m/s]
    double peak_force = 0.0;  ///< on the ball, greatest mean of a millisecond           [N]
    std::size_t facets = 0;   ///< of the membrane
};

/// A ball of 0.5 kg and 0.1 m across falls on a membrane of 0.4 m, strained by 1 % and held at its
/// rim, of 2 n² facets, off its middle by so much.
Rebound drop(Index n, int ball_levels, double off) {
    Model model = scenes::empty(40e-3);
    const support::Sheet sheet = support::square_sheet(n, 0.4);
    scenes::add(model, sheet.x, sheet.triangles, scenes::cloth(), 3e-4, {-0.2, -0.2, 0});
    ReferenceGeometry slack;
    for (std::size_t i = 0; i < model.x.size(); ++i) {
        slack.nodes.emplace_back(static_cast<Index>(i), model.x[i] / 1.01);
        if (model.x[i].cwiseAbs().maxCoeff() > 0.1999)
            model.supports.push_back({static_cast<Index>(i), 7U});
    }
    model.references = {slack};
    const Index ball = scenes::add(model, shapes::sphere(0.05, ball_levels), scenes::rigid(1000.0),
                                   1e-3, {off, 0.6 * off, 0.052});
    model.rigid_inertia = {{ball, 0.5, {off, 0.6 * off, 0.052}, 5e-4 * Mat3::Identity()}};
    model.rigid_velocity = {{ball, Vec3(0, 0, -SPEED), Vec3::Zero()}};
    scenes::touch(model);
    Simulation simulation(model);
    Rebound out;
    out.facets = sheet.triangles.size();
    std::deque<std::pair<double, double>> past;  // times and speeds of the last millisecond
    scenes::run(simulation, [&](Simulation& s) {
        past.emplace_back(s.time(), s.bodies()[0].velocity().z());
        while (past.back().first - past[1].first >= 1e-3) past.pop_front();
        const auto& [t, v] = past.front();
        if (past.back().first - t >= 1e-3)
            out.peak_force =
                std::max(out.peak_force, 0.5 * (past.back().second - v) / (past.back().first - t));
    });
    out.speed = simulation.bodies()[0].velocity().z();
    return out;
}

/// What is left in the membrane's waves is as chance has it: the mean of three falls.
Rebound mean_drop(Index n, int ball_levels) {
    Rebound mean{0.0};
    for (const double off : {0.0, 1e-3, 2e-3}) {
        const Rebound one = drop(n, ball_levels, off);
        WARN(one.facets << " facets, off by " << off << " m: rebound at " << one.speed << " m/s of "
                        << SPEED << ", peak force " << one.peak_force << " N");
        mean.speed += one.speed / 3.0;
        mean.peak_force += one.peak_force / 3.0;
    }
    return mean;
}

}  // namespace

TEST_CASE("a ball's rebound from a taut membrane and its peak force converge with refinement",
          "[contact][rigid]") {
    const Rebound coarse = mean_drop(12, 2), middle = mean_drop(24, 3), fine = mean_drop(48, 4);
    CHECK(std::abs(fine.speed - middle.speed) < 0.01 * SPEED);
    CHECK(std::abs(fine.speed - coarse.speed) < 0.01 * SPEED);
    CHECK(fine.speed > 0.9 * SPEED);
    CHECK(fine.speed < 1.01 * SPEED);
    CHECK(std::abs(fine.peak_force - middle.peak_force) < 0.02 * fine.peak_force);
    CHECK(std::abs(fine.peak_force - middle.peak_force) <
          std::abs(fine.peak_force - coarse.peak_force));
}
