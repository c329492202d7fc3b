// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: walls that are driven against what is held leave the same bits in every sample, energy
// accounts included, whether the run goes through or is restarted after each of its steps.
#include <catch2/catch.hpp>

#include "solver/base/archive.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

Index curve(Model& model, std::vector<double> x, std::vector<double> y) {
    model.curves.push_back({static_cast<int>(model.curves.size()) + 1, std::move(x), std::move(y)});
    return static_cast<Index>(model.curves.size() - 1);
}

/// Nodes of a part.
std::vector<Index> nodes_of(const Model& model, Index part) {
    std::vector<std::uint8_t> is_there(model.x.size(), 0);
    for (const Shell& shell : model.shells)
        if (shell.part == part)
            for (const Index n : shell.nodes) is_there[n] = 1;
    std::vector<Index> nodes;
    for (std::size_t n = 0; n < is_there.size(); ++n)
        if (is_there[n]) nodes.push_back(static_cast<Index>(n));
    return nodes;
}

void add_wall(Model& model, const contact::WallShape& shape, const contact::WallMotion& motion,
              Index part) {
    contact::WallCard wall;
    wall.id = static_cast<int>(model.walls.size()) + 1;
    wall.shape = shape;
    wall.motion = motion;
    wall.friction = 0.3;
    wall.nodes = nodes_of(model, part);
    model.walls.push_back(wall);
}

/// A ball of cloth, some of whose nodes are held, beside a brick that is carried along x; and four
/// walls: a ball driven by a speed and a plane of mass against the cloth, a plate driven by a
/// displacement and a plane at a constant speed against the brick. The cloth touches itself.
Model driven_scene() {
    Model model = scenes::empty(1.2e-3);
    const Index cloth =
        scenes::add(model, shapes::sphere(0.1, 2), scenes::cloth(), 3e-4, Vec3::Zero());
    const Index brick =
        scenes::add(model, shapes::box({0.4, 0.2, 0.1}), scenes::rigid(1000.0), 1e-3, {1, 0, 0});
    for (const Index n : nodes_of(model, cloth)) {
        const bool is_low = model.x[n].z() < -0.05;
        if (is_low) model.supports.push_back({n, model.x[n].x() > 0.0 ? 0b101U : 0b111U});
        model.velocity[n] = is_low ? Vec3::Zero() : Vec3(0.0, 0.0, 10.0);
    }
    PrescribedMotion along;
    along.rigid_part = brick;
    along.curve = curve(model, {0.0, 1.0}, {3.0, 4.0});
    model.motions = {along};

    const Vec3 up = Vec3::UnitZ();
    contact::WallMotion by_speed{up, curve(model, {0.0, 0.4e-3, 1.0}, {0.0, 25.0, 25.0})};
    add_wall(model, contact::Ball{Vec3(0.02, 0.0, -0.153), 0.05}, by_speed, cloth);
    add_wall(model, contact::HalfSpace{Vec3(0.0, 0.0, 0.102), -up}, {-up, -1, false, 8.0, 0.02},
             cloth);
    contact::Plate plate;
    plate.corner = Vec3(0.9, -0.1, -0.002);
    plate.axes = Mat3::Identity();
    plate.low[0] = plate.low[1] = 0.0;
    plate.high[0] = plate.high[1] = 0.6;
    contact::WallMotion by_displacement{(up + 0.2 * Vec3::UnitX()).normalized(),
                                        curve(model, {0.0, 0.6e-3, 1.2e-3}, {0.0, 6e-3, 9e-3}),
                                        true};
    add_wall(model, plate, by_displacement, brick);
    add_wall(model, contact::HalfSpace{Vec3(0.0, -0.001, 0.0), Vec3::UnitY()},
             {Vec3::UnitY(), -1, false, 2.5}, brick);
    model.step_factor = 0.2;
    contact::ContactCard card;
    card.friction_static = card.friction_dynamic = 0.2;
    scenes::touch(model, card);
    return model;
}

/// What a run hands to its results, step after step.
struct Told {
    std::vector<std::vector<char>> samples;
    EnergyBooks books;                ///< at the end
    double driven = 0.0, held = 0.0;  ///< work of walls, and of what holds bodies            [J]
    std::vector<double> stopped;      ///< by wall                                            [J]
    std::vector<char> state;          ///< at the end
};

Told run(bool is_restarted) {
    const Model model = driven_scene();
    auto simulation = std::make_unique<Simulation>(model);
    Told told;
    const auto watch = [&](Simulation& at) {
        StateWriter bytes;
        Sample sample = at.sample();
        bytes(sample);
        told.samples.push_back(bytes.take());
        told.books = sample.energy;
    };
    while (!simulation->is_over()) {
        simulation->step(watch);
        StateWriter state;
        state(*simulation);
        told.state = state.take();
        if (!is_restarted) continue;
        simulation = std::make_unique<Simulation>(model);
        StateReader reader(told.state);
        reader(*simulation);
        REQUIRE(reader.is_at_end());
    }
    simulation->close(watch);
    for (const contact::RigidWall& wall : simulation->walls()) {
        told.driven += std::abs(wall.driving_work());
        told.held += std::abs(wall.held_work());
        told.stopped.push_back(wall.stopping_energy());
    }
    return told;
}

}  // namespace

TEST_CASE("walls driven against what is held: a restart after every step leaves no trace",
          "[solver][wall][restart]") {
    const Told whole = run(false), broken = run(true);
    CAPTURE(whole.samples.size(), whole.driven, whole.held, whole.stopped, whole.books.residual,
            whole.books.kinetic, whole.books.external);
    CHECK(whole.samples.size() > 100);
    CHECK(whole.driven > 0.01);
    CHECK(whole.held > 0.01);
    for (const double energy : whole.stopped) CHECK(energy > 0.0);
    CHECK(whole.books.friction > 0.0);
    CHECK(std::abs(whole.books.residual) < 0.01 * (whole.books.kinetic + whole.driven));
    REQUIRE(broken.samples.size() == whole.samples.size());
    for (std::size_t k = 0; k < whole.samples.size(); ++k)
        if (broken.samples[k] != whole.samples[k]) FAIL("other bits first in step " << k);
    CHECK(broken.state == whole.state);
}
