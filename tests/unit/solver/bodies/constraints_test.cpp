// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Prescribed accelerations that act from their birth on.

#include "solver/bodies/constraints.hpp"

#include <catch2/catch.hpp>

#include <memory>

#include "solver/base/archive.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/touching_bodies.hpp"

using namespace corpuscle;

namespace {

constexpr double BIRTH = 0.01, ACCELERATION = 40.0, GRAVITY = 9.81;

/// A square whose nodes 0 and 1 are driven, and a body that is driven and one that is turned.
Model driven(double birth) {
    Model model = scenes::empty(0.02);
    const Points square{{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}, {0, 0.1, 0}};
    const std::vector<Triangle> halves{{0, 1, 2}, {0, 2, 3}};
    scenes::add(model, square, halves, scenes::null_material(), 1e-3, Vec3::Zero());
    for (int k = 0; k < 2; ++k)
        scenes::add(model, shapes::sphere(0.1, 1), scenes::rigid(1000.0), 1e-3, Vec3(k + 1, 0, 0));
    scenes::pull(model, Vec3(0, 0, -GRAVITY));
    model.velocity[0] = Vec3(1, 0, 3);
    model.velocity[1] = Vec3(0, 2, -1);
    model.rigid_velocity = {{1, Vec3(0, 0, 2), Vec3::Zero()}, {2, Vec3::Zero(), Vec3(0, 0, 5)}};
    model.curves.push_back({99, {0.0, 1.0}, {ACCELERATION, ACCELERATION}});
    PrescribedMotion motion;
    motion.kind = MotionKind::ACCELERATION;
    motion.axis = Vec3::UnitZ();
    motion.curve = static_cast<Index>(model.curves.size()) - 1;
    motion.birth = birth;
    model.motions.assign(3, motion);
    model.motions[0].nodes = {0, 1};
    model.motions[1].rigid_part = 1;
    model.motions[2].rigid_part = 2;
    model.motions[2].rotation = true;
    return model;
}

}  // namespace

TEST_CASE("a prescribed acceleration begins with what each node and body then has",
          "[solver][rigid]") {
    const double birth = GENERATE(0.0, BIRTH);
    Simulation simulation(driven(birth));
    std::size_t looks = 0;
    double worst = 0.0;
    const auto watch = [&](Simulation& at) {
        const double t = at.time(), by = std::max(0.0, t - birth);
        const double fallen = -GRAVITY * std::min(t, birth) + ACCELERATION * by;
        Sample now = at.sample();
        const SceneState& scene = at.scene();
        for (const auto& [is, expected] : {std::pair{scene.velocity(0).z(), 3.0 + fallen},
                                           {scene.velocity(1).z(), -1.0 + fallen},
                                           {now.rigid_bodies[0].velocity.z(), 2.0 + fallen},
                                           {at.bodies()[1].spin().z(), 5.0 + ACCELERATION * by}}) {
            worst = std::max(worst, std::abs(is - expected));
        }
        CHECK(scene.velocity(1).y() == Approx(2.0).epsilon(1e-14));
        ++looks;
    };
    while (!simulation.is_over()) simulation.step(watch);
    CHECK(looks > 100);
    CHECK(worst < 2.0 * (ACCELERATION + GRAVITY) * simulation.scene().clock.dt_last);
}

TEST_CASE("a restart amid prescribed accelerations leaves no trace", "[solver][restart]") {
    const Model model = driven(BIRTH);
    const auto told = [&](bool is_restarted) {
        auto simulation = std::make_unique<Simulation>(model);
        std::vector<std::vector<char>> states;
        while (!simulation->is_over()) {
            simulation->step([](Simulation&) {});
            StateWriter state;
            state(*simulation);
            states.push_back(state.take());
            if (!is_restarted) continue;
            simulation = std::make_unique<Simulation>(model);
            StateReader reader(states.back());
            reader(*simulation);
            REQUIRE(reader.is_at_end());
        }
        return states;
    };
    CHECK(told(false) == told(true));
}
