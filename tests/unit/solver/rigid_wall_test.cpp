// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>

#include "solver/simulation.hpp"
#include "tests/support/scenes.hpp"

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
        if (!sample.wall_force[0].isZero(0.0)) ++worst.touched;
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
    const Worst worst = run(model, [](Simulation& at, const Sample& sample) {
        double p = 0.02 * sample.moving_walls[0].velocity.z();
        for (std::size_t n = 0; n < at.nodes().size(); ++n)
            p += at.nodes().mass[n] * at.nodes().v[n].z();
        return p;
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
