// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

/// A sphere of cloth that flies down at 20 m/s onto the wall.
Model thrown(const contact::WallCard& wall) {
    Model model = scenes::of(shapes::sphere(0.1, 2), scenes::cloth(), 3e-4);
    for (Vec3& v : model.velocity) v = Vec3(0.0, 0.0, -20.0);
    model.curves = {Curve{1, {0.0, 1e-3, 3e-3}, {0.0, 0.0, 12.0}}};
    model.walls = {wall};
    model.walls[0].id = 1;
    for (std::size_t n = 0; n < model.x.size(); ++n)
        model.walls[0].nodes.push_back(static_cast<Index>(n));
    model.end_time = 5e-3;
    model.step_factor = 0.5;
    return model;
}

struct Worst {
    double residual = 0.0, momentum = 0.0, depth = 0.0;
    std::size_t touched = 0;
};

template <class Momentum>
Worst run(Model model, Momentum&& momentum) {
    Simulation simulation(std::move(model));
    Worst worst;
    double before = NaN;
    const auto watch = [&](Simulation& at) {
        const Sample sample = at.sample();
        const double now = momentum(at, sample);
        if (std::isnan(before)) before = now;
        worst.momentum = std::max(worst.momentum, std::abs(now - before));
        worst.residual = std::max(worst.residual, std::abs(sample.energy.residual));
        if (!at.walls()[0].force().isZero(0.0)) ++worst.touched;
        for (const Vec3& x : at.nodes().x) {
            const Vec3 seen =
                x - (sample.moving_walls.empty() ? Vec3(Vec3::Zero())
                                                 : sample.moving_walls[0].displacement);
            worst.depth =
                std::max(worst.depth, -contact::nearest(at.model().walls[0].shape, seen).gap);
        }
    };
    while (!simulation.is_over()) simulation.step(watch);
    simulation.close(watch);
    return worst;
}

double kinetic(const Model& model) {
    Simulation simulation(model);
    double energy = 0.0;
    simulation.step([&](Simulation& at) { energy = at.books().kinetic; });
    return energy;
}

}  // namespace

TEST_CASE("cloth on a wall of mass: momentum is shared, and the energy books close",
          "[solver][wall]") {
    contact::WallCard wall;
    wall.shape = contact::HalfSpace{Vec3(0.0, 0.0, -0.105), Vec3::UnitZ()};
    wall.motion = {Vec3::UnitZ(), -1, false, 5.0, 0.02};
    const Model model = thrown(wall);
    const Worst worst = run(model, [](Simulation&, const Sample& sample) {
        return 0.02 * sample.moving_walls[0].velocity.z() + sample.parts[0].momentum.z();
    });
    CAPTURE(worst.residual, worst.momentum, worst.depth, worst.touched);
    CHECK(worst.touched > 20);
    CHECK(worst.momentum < 1e-12);
    CHECK(worst.residual < 0.01 * kinetic(model));
    CHECK(worst.depth < 1e-12);
}

TEST_CASE("cloth on a driven ball with friction: the books close, no node gets in",
          "[solver][wall]") {
    contact::WallCard wall;
    wall.shape = contact::Ball{Vec3(0.03, 0.0, -0.16), 0.05};
    wall.motion.direction = Vec3::UnitZ();
    wall.motion.curve = 0;
    wall.friction = 0.3;
    const Model model = thrown(wall);
    const Worst worst = run(model, [](Simulation&, const Sample&) { return 0.0; });
    CAPTURE(worst.residual, worst.depth, worst.touched);
    CHECK(worst.touched > 20);
    CHECK(worst.residual < 0.01 * kinetic(model));
    CHECK(worst.depth < 1e-12);
}

namespace {

/// A rigid brick 0.4 x 0.2 x 0.1 whose base is at z = 0.
Model brick() {
    shapes::Shape shape;
    for (int n = 0; n < 8; ++n)
        shape.x.emplace_back(0.4 * (n & 1), 0.2 * (n >> 1 & 1), 0.1 * (n >> 2));
    shape.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                       {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    fabric::RigidCard rigid;
    rigid.density = 1000.0;
    rigid.E = 1e9;
    rigid.nu = 0.3;
    Model model = scenes::of(shape, rigid, 1e-3);
    contact::WallCard wall;
    wall.id = 1;
    wall.shape = contact::HalfSpace{Vec3::Zero(), Vec3::UnitZ()};
    wall.nodes = {0, 1, 2, 3, 4, 5, 6, 7};
    model.walls = {wall};
    return model;
}

}  // namespace

TEST_CASE("a brick that is thrown on a wall stops there, and the wall gets its momentum",
          "[solver][wall]") {
    const bool is_tilted = GENERATE(false, true);
    Model model = brick();
    const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 0).normalized()).toRotationMatrix();
    for (Vec3& x : model.x) x = (is_tilted ? Vec3(turn * x) : x) + Vec3(0, 0, 0.2);
    model.rigid_velocity = {{0, Vec3(0, 0, -4), Vec3::Zero()}};
    model.end_time = is_tilted ? 0.06 : 0.1;
    Simulation simulation(model);
    double pushed = 0.0, low = 0.0, kinetic = INF, worst = 0.0;
    Vec3 velocity = Vec3::Zero();
    const auto watch = [&](Simulation& at) {
        const Sample sample = at.sample();
        pushed = sample.wall_impulse[0].z();
        velocity = sample.rigid_bodies[0].velocity;
        CHECK(sample.energy.kinetic <= kinetic * (1.0 + 1e-9));
        kinetic = sample.energy.kinetic;
        worst = std::max(worst, std::abs(sample.energy.residual));
        for (const Vec3& x : at.nodes().x) low = std::min(low, x.z());
    };
    while (!simulation.is_over()) simulation.step(watch);
    CAPTURE(low, worst, kinetic);
    const double mass = 1000.0 * 1e-3 * 2.0 * (0.08 + 0.04 + 0.02);
    CHECK(pushed == Approx(-mass * (4.0 + velocity.z())).epsilon(1e-12));
    CHECK(low > -1e-4);
    CHECK(worst < 1e-6 * 0.5 * mass * 16.0);
    if (!is_tilted) {
        CHECK(velocity.norm() < 1e-4);
        CHECK(kinetic < 1e-6);
    }
}

TEST_CASE("a brick on an incline sticks below the friction angle and slides above it",
          "[solver][wall]") {
    const double mu = 0.3, angle = std::atan(mu) + GENERATE(-0.03, 0.03, 0.3);
    constexpr double G = 9.81;
    Model model = brick();
    model.walls[0].friction = mu;
    model.curves = {Curve{1, {0.0, 1.0}, {1.0, 1.0}}};
    // bodies feel the opposite of the base's acceleration: down the slope along x
    model.body_loads = {{0, 0, -G * std::sin(angle), {}}, {2, 0, G * std::cos(angle), {}}};
    model.end_time = 0.2;
    Simulation simulation(model);
    const auto nothing = [](Simulation&) {};
    while (!simulation.is_over()) simulation.step(nothing);
    Vec3 velocity = Vec3::Zero();
    simulation.close([&](Simulation& at) { velocity = at.sample().rigid_bodies[0].velocity; });
    const double slide = std::max(0.0, std::sin(angle) - mu * std::cos(angle));
    CHECK(velocity.x() == Approx(G * slide * 0.2).epsilon(0.01).margin(1e-4));
    CHECK(std::abs(velocity.z()) < 1e-4);
}

TEST_CASE("a brick that glides above a wall that sticks goes on", "[solver][wall]") {
    Model model = brick();
    for (Vec3& x : model.x) x.z() += 1e-4;
    model.walls[0].friction = 1.0;
    model.rigid_velocity = {{0, Vec3::UnitX(), Vec3::Zero()}};
    model.end_time = 0.05;
    Simulation simulation(model);
    const auto nothing = [](Simulation&) {};
    while (!simulation.is_over()) simulation.step(nothing);
    simulation.close([&](Simulation& at) {
        CHECK((at.sample().rigid_bodies[0].velocity - Vec3::UnitX()).norm() < 1e-12);
    });
}
