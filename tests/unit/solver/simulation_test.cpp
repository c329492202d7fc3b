// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/simulation.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/particles.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"
#include "tests/support/scenes/flying_bag.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;
using scenes::flying_bag;
using scenes::Momentum;
using scenes::momentum;

namespace {

const auto nothing = [](Simulation&) {};

}  // namespace

TEST_CASE("free fall is exact", "[solver]") {
    Model model = scenes::of(shapes::sphere(0.1, 1), scenes::cloth(), 3e-4);
    model.curves = {Curve{1, {0.0, 1.0}, {9.81, 9.81}}};
    model.body_loads = {{2, 0, 1.0, {}}};
    model.end_time = 2e-3;
    Simulation simulation(model);
    while (!simulation.is_over()) simulation.step(nothing);
    for (std::size_t n = 0; n < model.x.size(); ++n)
        CHECK(simulation.nodes().x[n].z() - model.x[n].z() ==
              Approx(-0.5 * 9.81 * 2e-3 * 2e-3).epsilon(1e-9));
    CHECK(simulation.time() == 2e-3);
}

TEST_CASE("the energy books of a pressed membrane close with the square of the step",
          "[solver][ledger]") {
    const auto open_by = [](double step_factor) {
        Model model = scenes::of(shapes::sphere(0.1, 2), scenes::cloth(), 3e-4);
        PressureLoad load;
        load.scale = -20e3;  // outward: against the sign of a pressure on the outer face
        for (const Shell& shell : model.shells) load.facets.push_back(shell.nodes);
        model.pressure_loads = {load};
        model.end_time = 2e-3;
        model.step_factor = step_factor;
        Simulation simulation(model);
        double worst = 0.0, brought = 0.0;
        const auto watch = [&](Simulation& at_t) {
            worst = std::max(worst, std::abs(at_t.books().residual));
            brought = std::max(brought, at_t.books().external);
        };
        while (!simulation.is_over()) simulation.step(watch);
        simulation.close(watch);
        return worst / brought;
    };
    const double coarse = open_by(0.4), fine = open_by(0.1);
    CAPTURE(coarse, fine);
    CHECK(coarse < 0.02);
    CHECK(fine < coarse / 12.0);  // 16 for a second-order method
}

TEST_CASE("prescribed motion carries nodes by the curve's integral", "[solver]") {
    Model model = scenes::of(shapes::box({1, 1, 1}, 1), scenes::null_material(), 1e-3);
    model.curves = {Curve{1, {0.0, 1e-3, 2e-3}, {0.0, 10.0, 0.0}}};
    PrescribedMotion motion;
    motion.nodes = {0, 1};
    motion.axis = Vec3::UnitY();
    motion.curve = 0;
    model.motions = {motion};
    model.end_time = 2e-3;
    Simulation simulation(model);
    while (!simulation.is_over()) simulation.step(nothing);
    CHECK(simulation.nodes().x[0].y() - model.x[0].y() == Approx(0.01).epsilon(1e-12));
    CHECK(simulation.nodes().x[2] == model.x[2]);
    CHECK(simulation.active_shells() == 0);
}

TEST_CASE("what a curve drives to its end has no jerk in the last sample", "[solver]") {
    const bool by_way = GENERATE(true, false);
    // 3 m/s throughout, or speeding up by 2000 m/s^2
    const Curve way{1, {0.0, 1e-3, 2e-3}, {0.0, 3e-3, 6e-3}}, speed{1, {0.0, 2e-3}, {3.0, 7.0}};
    const double v_end = by_way ? 3.0 : 7.0, acceleration = by_way ? 0.0 : 2000.0;
    fabric::RigidCard rigid;
    rigid.density = 1000.0;
    rigid.E = 1e9;
    const bool is_body = GENERATE(true, false);
    Model model = is_body ? scenes::of(shapes::box({1, 1, 1}, 1), rigid, 1e-3)
                          : scenes::of(shapes::box({1, 1, 1}, 1), scenes::null_material(), 1e-3);
    model.curves = {by_way ? way : speed};
    PrescribedMotion motion;
    if (is_body)
        motion.rigid_part = 0;
    else
        motion.nodes = {0, 1};
    motion.axis = Vec3::UnitY();
    motion.curve = 0;
    motion.kind = by_way ? MotionKind::DISPLACEMENT : MotionKind::VELOCITY;
    model.motions = {motion};
    contact::WallCard wall;
    wall.shape = contact::HalfSpace{Vec3(0, 0, -9), Vec3::UnitZ()};
    wall.motion.direction = Vec3::UnitZ();
    wall.motion.curve = 0;
    wall.motion.is_displacement = by_way;
    model.walls = {wall};
    model.history_nodes = {0};
    model.end_time = 2e-3;
    Simulation simulation(model);
    while (!simulation.is_over()) simulation.step(nothing);
    Sample end;
    simulation.close([&](Simulation& at) { end = at.sample(); });
    CHECK(end.moving_walls.at(0).velocity.z() == Approx(v_end).epsilon(1e-9));
    CHECK(end.node_velocity.at(0).y() == Approx(v_end).epsilon(1e-9));
    if (!is_body) return;
    CHECK(end.rigid_bodies.at(0).velocity.y() == Approx(v_end).epsilon(1e-9));
    CHECK(end.rigid_bodies.at(0).acceleration.y() ==
          Approx(acceleration).epsilon(1e-6).margin(1e-3));
}

TEST_CASE("a flying bag and its gas keep their momentum and energy", "[solver][gas]") {
    Model model = flying_bag(2000);
    model.end_time = 3e-3;
    Simulation simulation(model);
    Vec3 brought = Vec3::Zero();
    while (simulation.time() < 1.1e-3) simulation.step(nothing);  // all gas is in
    brought = momentum(simulation).all();
    double worst = 0.0, inflow = 0.0;
    const auto watch = [&](Simulation& at_t) {
        worst = std::max(worst, std::abs(at_t.books().residual));
        inflow = at_t.books().inflow;
    };
    while (!simulation.is_over()) simulation.step(watch);
    CHECK((momentum(simulation).all() - brought).norm() <
          1e-9 * momentum(simulation).fabric.norm());
    CHECK(inflow > 100.0);
    CHECK(worst < 1e-3 * inflow);
    CHECK(simulation.bags()[0].lost() == 0);
    for (const Vec3& x : simulation.bags()[0].particles().x)
        REQUIRE(simulation.bags()[0].enclosure().contains(x, simulation.nodes().x));
}

TEST_CASE("any number of threads gives the same bits", "[solver][threads]") {
    const auto run = [](int threads) {
        parallel::set_threads(threads);
        Model model = flying_bag(3000);
        model.end_time = 1.5e-3;
        Simulation simulation(model, 5);
        while (!simulation.is_over()) simulation.step(nothing);
        return simulation;
    };
    const Simulation one = run(1), two = run(2);
    CHECK(one.nodes().x == two.nodes().x);
    CHECK(one.bags()[0].particles().x == two.bags()[0].particles().x);
    CHECK(one.bags()[0].particles().v == two.bags()[0].particles().v);
    CHECK(one.bags()[0].particles().e == two.bags()[0].particles().e);
}

TEST_CASE("an unstable step ends with the time and the element", "[solver]") {
    Model model = scenes::of(shapes::sphere(0.1, 2), scenes::cloth(), 3e-4);
    model.velocity[0] = Vec3(0, 0, 20.0);
    model.step_factor = 1.3;
    model.end_time = 1.0;
    Simulation simulation(model);
    CHECK_THROWS_AS(
        [&] {
            while (!simulation.is_over()) simulation.step(nothing);
        }(),
        PhysicsError);
}

TEST_CASE("a bag that is not closed is refused with its free edges", "[solver][gas]") {
    Model model = flying_bag(100);
    model.shells.pop_back();
    CHECK_THROWS_AS(Simulation(model), InputError);
}

TEST_CASE("an orifice outside its bag is refused by its field", "[solver][gas]") {
    Model model = scenes::of(shapes::box({1, 1, 1}, 1), scenes::null_material(), 1e-3);
    scenes::fix_all_nodes(model);
    scenes::fill(model, scenes::air(), 0.1, 0.01, 400.0, Vec3(0.5, 0.5, 1.5), 100);
    CHECK_THROWS_WITH(Simulation(model),
                      Catch::Contains("bag 1, place of orifice 1: (0.5, 0.5, 1.5)"));
}
