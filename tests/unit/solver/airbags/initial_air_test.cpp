// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Initial air that is no particles (IAIR = 1): a control volume in each room.
#include <catch2/catch.hpp>

#include <cmath>

#include "solver/base/error.hpp"
#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

constexpr double AIR_PRESSURE = 1e5;

void fill_with_initial_air(Model& model, std::vector<Index> hull, std::vector<Index> inside = {}) {
    gas::BagCard bag;
    bag.id = 1;
    bag.external_parts = std::move(hull);
    bag.internal_parts = std::move(inside);
    bag.particles = 1000;
    bag.p_atm = AIR_PRESSURE;
    bag.air = gas::InitialAirCard{scenes::air(), AIR_PRESSURE, 293.0};
    model.bags = {bag};
}

/// A rigid box of a litre whose lid, a rigid body of 0.1 kg, slides up and down on its air. (Its
/// sides are of next to no mass.)
Model lid_on_air(double velocity) {
    fabric::NullCard sides = scenes::null_material();
    sides.density = 1e-6;
    Model model = scenes::of(shapes::box(Vec3::Constant(0.1), 1), sides, 1e-3);
    fabric::RigidCard card;
    card.density = 1e4;
    card.E = 1e9;
    card.fixed_moves = 0b011;
    card.fixed_turns = 0b111;
    model.materials.push_back({2, "", card});
    model.parts.push_back(model.parts[0]);
    model.parts[1].id = 2;
    model.parts[1].material = 1;
    for (Shell& shell : model.shells) {
        const auto& [a, b, c, d] = shell.nodes;
        if (std::min({model.x[a].z(), model.x[b].z(), model.x[c].z()}) > 0.09) shell.part = 1;
    }
    for (std::size_t n = 0; n < model.x.size(); ++n)
        if (model.x[n].z() < 0.01) model.supports.push_back({static_cast<Index>(n), 7U});
    model.rigid_velocity = {{1, Vec3(0.0, 0.0, velocity), Vec3::Zero()}};
    fill_with_initial_air(model, {0, 1});
    return model;
}

/// A rigid box of 0.1 m with a membrane over three quarters of its bottom, fast at the rim, whose middle is at
/// `height` and flies up at a velocity, too heavy for any gas.
Model pyramid_in_box(double height, double velocity) {
    Model model = scenes::of(shapes::box(Vec3::Constant(0.1), 2), scenes::null_material(), 1e-3);
    const auto is_middle = [&](Index n) {
        return (model.x[n] - Vec3(0.05, 0.05, 0)).norm() < 1e-9;
    };
    model.parts.push_back(model.parts[0]);
    model.parts[1].id = 2;
    model.parts[1].material = 1;
    fabric::NullCard heavy = scenes::null_material();
    heavy.density = 1e6;
    model.materials.push_back({2, "", heavy});
    const auto top = static_cast<Index>(model.x.size());
    const std::size_t hull = model.shells.size();
    for (std::size_t s = 0; s < hull; ++s) {
        Shell shell = model.shells[s];
        if (std::none_of(shell.nodes.begin(), shell.nodes.end(), is_middle)) continue;
        for (Index& n : shell.nodes) n = is_middle(n) ? top : n;
        shell.part = 1;
        shell.id = static_cast<int>(model.shells.size()) + 1;
        model.shells.push_back(shell);
    }
    scenes::fix_all_nodes(model);
    model.x.emplace_back(0.05, 0.05, height);
    model.velocity.emplace_back(0.0, 0.0, velocity);
    model.node_id.push_back(static_cast<int>(model.x.size()));
    fill_with_initial_air(model, {0}, {1});
    model.end_time = 2e-3;
    return model;
}

}  // namespace

TEST_CASE("a lid that swings on initial air keeps its amplitude, and the energies balance",
          "[solver][gas]") {
    constexpr double SPEED = 0.5, PERIOD = 2.0 * M_PI / 377.0;
    const auto residual_until = [&](double end) {  // in a thousand steps
        Model model = lid_on_air(SPEED);
        model.end_time = end;
        Simulation simulation(model);
        double first = 0.0, last = 0.0, residual = 0.0;
        while (!simulation.is_over())
            simulation.step([&](Simulation& at) {
                const double now = at.books().kinetic, t = at.time();
                residual = std::max(residual, std::abs(at.books().residual));
                if (t < PERIOD) first = std::max(first, now);
                if (t > model.end_time - PERIOD) last = std::max(last, now);
            });
        CHECK(first == Approx(0.5 * 0.1 * SPEED * SPEED).epsilon(0.01));
        CHECK(last == Approx(first).epsilon(0.02));
        return residual / first;
    };
    const double residual = residual_until(0.2);
    CHECK(residual < 0.2);
    CHECK(residual_until(0.1) < 0.3 * residual);
}

TEST_CASE("a room without volume has no initial air, and the others have theirs", "[solver][gas]") {
    const double height = GENERATE(0.0, 1e-15, -1e-15);
    Simulation simulation(pyramid_in_box(height, 10.0));
    const auto& told = simulation.bags()[0].warnings();
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("it has no initial air") != std::string::npos);
    double lowest = INF, residual = 0.0;
    while (!simulation.is_over())
        simulation.step([&](Simulation& at) {
            lowest = std::min(lowest, at.bags()[0].state(at.nodes().x).pressure);
            residual = std::max(residual, std::abs(at.books().residual));
        });
    CHECK(lowest > 0.9 * AIR_PRESSURE);
    CHECK(residual < 1.0);  // of 130 J that the air holds
}

TEST_CASE("initial air of a room that comes to no volume stops the run and names the room",
          "[solver][gas]") {
    Simulation simulation(pyramid_in_box(1e-3, -2000.0));
    std::string why;
    try {
        while (!simulation.is_over()) simulation.step([](Simulation&) {});
    } catch (const PhysicsError& error) {
        why = error.what();
    }
    CAPTURE(why);
    CHECK(why.find("bag 1, room ") != std::string::npos);
    CHECK(why.find("the volume is -") != std::string::npos);
}

TEST_CASE("a sensor reads the initial air's pressure of the room that it is in", "[solver][gas]") {
    Model model = pyramid_in_box(0.03, 5.0);
    const auto segment = [&](double z) -> std::array<Index, 4> {
        for (const Shell& shell : model.shells) {
            const auto& [a, b, c, d] = shell.nodes;
            if (shell.part == 0 && std::abs(model.x[a].z() - z) + std::abs(model.x[b].z() - z) +
                                           std::abs(model.x[c].z() - z) <
                                       1e-9)
                return shell.nodes;
        }
        return {};
    };
    using Shape = gas::SensorCard::Shape;
    model.sensors = {{Shape::SPHERE, segment(0.0), -2e-3, {1e-3}},
                     {Shape::SPHERE, segment(0.1), -2e-2, {1e-3}}};
    Simulation simulation(model);
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    simulation.close([&](Simulation& at_end) {
        const auto sample = at_end.sample();
        const double up =
            at_end.nodes().x.back().z() / 0.03;  // volume of the pyramid, of that first
        const double small = 7.5e-5, large = 9.25e-4, gamma = 28.0 / (28.0 - GAS_CONSTANT);
        const double below = AIR_PRESSURE * std::pow(up, -gamma);
        const double above = AIR_PRESSURE * std::pow(large / (large - small * (up - 1.0)), gamma);
        CHECK(up > 1.2);
        CHECK(sample.sensors.at(0).pressure == Approx(below).epsilon(2e-3));
        CHECK(sample.sensors.at(1).pressure == Approx(above).epsilon(2e-3));
    });
}
