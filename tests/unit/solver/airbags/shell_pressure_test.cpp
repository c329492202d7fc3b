// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Pressure of the gas on shells in frames, and on parts in samples.
#include <catch2/catch.hpp>

#include <array>
#include <vector>

#include "solver/simulation.hpp"
#include "tests/support/scenes/scenes.hpp"

using namespace corpuscle;

namespace {

constexpr double OUTSIDE = 1e5;

/// Two rigid boxes of 0.1 m, one on the other, with one wall in common: shells of parts 1 and 2 are
/// the hulls, part 3 is the wall.
Model two_boxes(bool is_wall_turned) {
    shapes::Shape shape;
    for (int k = 0; k < 3; ++k)
        for (const auto& [x, y] :
             {std::pair(0.0, 0.0), std::pair(0.1, 0.0), std::pair(0.1, 0.1), std::pair(0.0, 0.1)})
            shape.x.emplace_back(x, y, 0.1 * k);
    std::vector<Index> part;
    const auto quad = [&](Index of, Index a, Index b, Index c, Index d) {
        shape.triangles.push_back({a, b, c});
        shape.triangles.push_back({a, c, d});
        part.insert(part.end(), {of, of});
    };
    for (const Index k : {0, 1})
        for (const Index side : {0, 1, 2, 3}) {
            const Index next = (side + 1) % 4;
            quad(k, 4 * k + side, 4 * k + next, 4 * (k + 1) + next, 4 * (k + 1) + side);
        }
    quad(0, 0, 3, 2, 1);
    quad(1, 8, 9, 10, 11);
    if (is_wall_turned)
        quad(2, 4, 7, 6, 5);
    else
        quad(2, 4, 5, 6, 7);
    Model model = scenes::of(shape, scenes::null_material(), 1e-3);
    model.parts.resize(3, model.parts[0]);
    for (std::size_t s = 0; s < part.size(); ++s) model.shells[s].part = part[s];
    for (std::size_t p = 0; p < 3; ++p) model.parts[p].id = static_cast<int>(p) + 1;
    scenes::fix_all_nodes(model);
    return model;
}

/// A bag of still air over a hull and the wall.
gas::BagCard of_particles(Index hull, double pressure) {
    gas::BagCard bag;
    bag.id = hull + 1;
    bag.external_parts = {hull, 2};
    bag.p_atm = OUTSIDE;
    bag.air = gas::InitialAirCard{scenes::air(), pressure, 300.0};
    return bag;
}

gas::UniformBagCard of_uniform_gas(const Model& model, Index hull, double pressure) {
    gas::UniformBagCard card;
    card.keyword = "*AIRBAG_WANG_NEFSKE";
    card.id = hull + 1;
    for (std::size_t s = 0; s < model.shells.size(); ++s)
        if (model.shells[s].part == hull || model.shells[s].part == 2)
            card.shells.push_back(static_cast<Index>(s));
    card.cv = 718.0, card.cp = 1005.0;
    card.p_atm = OUTSIDE;
    card.overpressure = pressure - OUTSIDE;
    card.density = 1.2;
    return card;
}

}  // namespace

TEST_CASE("frames show what two bags do to the wall between them, outward of the first",
          "[solver][frames]") {
    Model model = two_boxes(GENERATE(false, true));
    const int of_particle_bags = GENERATE(0, 1, 2);
    for (const Index hull : {0, 1}) {
        const double pressure = hull == 0 ? 3e5 : 1.5e5;
        if (hull < of_particle_bags)
            model.bags.push_back(of_particles(hull, pressure));
        else
            model.uniform_bags.push_back(of_uniform_gas(model, hull, pressure));
    }
    model.end_time = 1e-3;
    Simulation simulation(model);
    const auto look = [&](Simulation& now) {
        const Frame frame = now.frame();
        for (std::size_t s = 0; s < model.shells.size(); ++s) {
            const std::array wanted{2e5, 0.5e5, 1.5e5};
            CHECK(frame.shell_pressure[s] ==
                  Approx(wanted[static_cast<std::size_t>(model.shells[s].part)]).epsilon(1e-6));
        }
    };
    simulation.step(look);
    while (!simulation.is_over()) simulation.step([](Simulation&) {});
    simulation.close(look);
}

TEST_CASE("frames show the mean pressure of uniform gas since the frame before",
          "[solver][frames]") {
    Model model = two_boxes(false);
    model.uniform_bags = {of_uniform_gas(model, 0, OUTSIDE)};
    model.curves.push_back({1, {0.0, 1.0}, {1.0, 1.0}});
    model.uniform_bags[0].mass_rate = 0;
    model.uniform_bags[0].temperature.value = 600.0;
    model.end_time = 4e-3;
    Simulation simulation(model);
    double since = 0.0, last = 0.0, sum = 0.0;
    int frames = 0;
    const auto look = [&](Simulation& now) {
        const double gauge = now.uniform_bags()[0].pressure() - OUTSIDE;
        sum += gauge * (now.time() - last);
        last = now.time();
        if (last > 0.0 && last < since + 1e-3) return;
        const double mean = last > 0.0 ? sum / (last - since) : gauge;
        CHECK(now.frame().shell_pressure[0] == Approx(mean).epsilon(1e-6));
        CHECK((last == 0.0 || mean < 0.9 * gauge));
        sum = 0.0, since = last;
        ++frames;
    };
    while (!simulation.is_over()) simulation.step(look);
    CHECK(frames > 3);
}

TEST_CASE("parts feel the mean pressure over the time between samples, across TSW, too",
          "[solver][gas]") {
    Model model = two_boxes(false);
    model.bags = {of_particles(0, OUTSIDE)};
    const bool is_particles = GENERATE(false, true);
    model.bags[0].air->is_particles = is_particles;
    model.bags[0].particles = 20000;
    model.bags[0].switch_at = 2e-3;
    model.end_time = 20e-3;  // steps of a thousandth of it from there on, before shorter ones
    Simulation simulation(model);
    double next = 0.0;
    const auto look = [&](Simulation& now) {
        if (now.time() < next && now.time() < model.end_time) return;
        next = now.time() + 1e-4;
        const AirbagSample bag = now.sample().airbags[0];
        if (now.time() == 0.0 || (is_particles && now.time() < 1.9e-3)) return;
        const bool is_mixed = is_particles && now.time() < 2.13e-3;
        CHECK(bag.parts[0].pressure == Approx(bag.pressure).epsilon(is_mixed ? 0.04 : 1e-9));
    };
    while (!simulation.is_over()) simulation.step(look);
    simulation.close(look);
}
