// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/sensor.hpp"

#include <catch2/catch.hpp>

#include <cmath>

#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

/// A rigid box of still air as particles, 40 cm long.
Model box_of_air(std::size_t particles) {
    Model model = scenes::of(shapes::box({0.4, 0.1, 0.1}, 1), scenes::null_material(), 1e-3);
    scenes::fix_all_nodes(model);
    gas::BagCard bag;
    bag.id = 1;
    bag.external_parts = {0};
    bag.particles = particles;
    bag.air = gas::InitialAirCard{scenes::air(), 1e5, 300.0, true};
    model.bags = {bag};
    model.end_time = 1e-4;
    return model;
}

/// A segment in the wall at x = 0, its normal outward.
std::array<Index, 4> wall(const Model& model) {
    for (const Shell& shell : model.shells) {
        const auto& [a, b, c, d] = shell.nodes;
        if (model.x[a].x() == 0.0 && model.x[b].x() == 0.0 && model.x[c].x() == 0.0)
            return shell.nodes;
    }
    return {};
}

Sample::Sensor reading(const Model& model) {
    Simulation simulation(model);
    Sample::Sensor found;
    simulation.step([&](Simulation& at_t) { found = at_t.sample().sensors.at(0); });
    return found;
}

}  // namespace

TEST_CASE("a sensor reads density, pressure and temperature of the gas around it",
          "[solver][gas]") {
    using Shape = gas::SensorCard::Shape;
    Model model = box_of_air(40000);
    gas::SensorCard sensor;
    sensor.nodes = wall(model);
    sensor.offset = -0.2;
    double volume = 0.0;
    SECTION("sphere") {
        sensor.size = {0.03, 0.0, 0.0};
        volume = 4.0 / 3.0 * M_PI * 0.03 * 0.03 * 0.03;
    }
    SECTION("cylinder") {
        sensor.shape = Shape::CYLINDER;
        sensor.size = {0.02, 0.2, 0.0};
        volume = M_PI * 0.02 * 0.02 * 0.2;
    }
    SECTION("box") {
        sensor.shape = Shape::BOX;
        sensor.size = {0.04, 0.05, 0.1};
        volume = 0.04 * 0.05 * 0.1;
    }
    model.sensors = {sensor};
    const Sample::Sensor found = reading(model);
    const double expected = 40000.0 * volume / 0.004;
    const double noise = 4.0 / std::sqrt(expected);  // 4 standard deviations
    const double density = 1e5 * 0.028 / (GAS_CONSTANT * 300.0);
    CHECK(found.particles == Approx(expected).epsilon(noise));
    CHECK(found.density == Approx(density).epsilon(noise));
    CHECK(found.temperature == Approx(300.0).epsilon(noise));
    CHECK(found.pressure == Approx(1e5).epsilon(2.0 * noise));
    CHECK(found.centre.x() == Approx(0.2));
    CHECK(found.velocity.norm() < noise * std::sqrt(3.0 * GAS_CONSTANT * 300.0 / 0.028));
}

TEST_CASE("a sensor over the whole bag reads its exact mean", "[solver][gas]") {
    Model model = box_of_air(500);
    gas::SensorCard sensor{gas::SensorCard::Shape::BOX, wall(model), -0.2, {1.0, 1.0, 1.0}};
    model.sensors = {sensor};
    const Sample::Sensor found = reading(model);
    CHECK(found.particles == 500);
    CHECK(found.density == Approx(1e5 * 0.028 / (GAS_CONSTANT * 300.0) * 0.004).epsilon(1e-9));
    CHECK(found.velocity.norm() < 1e-9);
    CHECK(found.temperature == Approx(300.0 * 500.0 / 499.0).epsilon(1e-9));
}

TEST_CASE("a sensor finds each particle that is within it", "[solver][gas]") {
    Model model = box_of_air(3000);
    model.end_time = 1e-2;
    std::vector<double> radius;
    for (const double at : {-0.39, -0.25, -0.1, 0.0, 0.05})
        for (const double size : {0.004, 0.03, 0.2}) {
            model.sensors.push_back(
                {gas::SensorCard::Shape::SPHERE, wall(model), at, {size, 0.0, 0.0}});
            radius.push_back(size);
        }
    Simulation simulation(model);
    for (int step = 0; step < 30; ++step)  // rows are put in order, and are left by their particles
        simulation.step([&](Simulation& at_t) {
            const Sample now = at_t.sample();
            for (std::size_t s = 0; s < radius.size(); ++s) {
                double inside = 0.0;
                for (const Vec3& x : at_t.bags()[0].particles().x)
                    inside += (x - now.sensors[s].centre).norm() <= radius[s];
                CHECK(now.sensors[s].particles == inside);
            }
        });
}

TEST_CASE("after the switch a sensor reads what its bag holds, and outside nothing",
          "[solver][gas]") {
    Model model = box_of_air(500);
    model.bags[0].switch_at = 1e-9;
    const bool is_inside = GENERATE(true, false);
    model.sensors = {{gas::SensorCard::Shape::SPHERE, wall(model), is_inside ? -0.2 : 0.2, {0.05}}};
    Simulation simulation(model);
    Sample::Sensor found;
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    simulation.close([&](Simulation& at_end) { found = at_end.sample().sensors.at(0); });
    CHECK(found.pressure == Approx(is_inside ? 1e5 : 0.0).epsilon(1e-9));
    CHECK(found.temperature == Approx(is_inside ? 300.0 : 0.0).epsilon(1e-9));
    CHECK((found.particles > 0.0) == is_inside);
}
