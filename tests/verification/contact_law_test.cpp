// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: layers of cloth give way under pressure as their law says, slide as friction says, and
// neither depends on the time step.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "tests/support/case_report.hpp"
#include "tests/support/layers_deck.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Modulus through the thickness over that in the plane [DESIGN: the law of contact].
constexpr double THROUGH = 1.0 / 30.0;

using Kind = Layer::Kind;

/// Curve 1: up to 1 within half a millisecond.
std::string ramp() { return curve_card(1, {{0.0, 0.0}, {0.5e-3, 1.0}, {1.0, 1.0}}); }

/// Layers on a plate, with meshes that do not fit each other.
LayersDeck stack(int count, double step) {
    LayersDeck deck;
    deck.step = step;
    deck.layers.push_back({.z = 0.0, .cells = 4, .side = 0.12, .kind = Kind::FIXED_PLATE});
    for (int l = 1; l <= count; ++l)
        deck.layers.push_back({.z = l * deck.thickness, .cells = 6 + l % 3, .side = 0.08});
    return deck;
}

double height_of_stack(int count, double step) {
    constexpr double PRESSURE = 200e3;
    const LayersDeck deck = stack(count, step);
    const std::size_t top = deck.layers.size() - 1;
    const DeckRun run(fmt::format("stack_{}_{}", count, static_cast<int>(100 * step)),
                      deck.text("layers on a plate", ramp() + deck.press(top, 1, PRESSURE), 3e-3,
                                1e-3));
    REQUIRE(run.status() == 0);
    double sum = 0.0, nodes = 0.0;
    for (const Vec3& x : layer_state(run, deck, top, last_frame(run)).x) {
        if (std::max(std::abs(x.x()), std::abs(x.y())) > 0.025) continue;
        sum += x.z();
        nodes += 1.0;
    }
    const double way = count - 1.0, E = THROUGH * deck.modulus;
    const double exact = deck.thickness * (way / (1.0 + PRESSURE / E) +
                                           1.0 / (1.0 + 0.5 * PRESSURE / E));
    report(fmt::format("height of {} layers, TSSFAC {} [mm]", count, step), 1e3 * exact,
           1e3 * sum / nodes);
    CHECK(sum / nodes == Approx(exact).epsilon(0.01));
    return sum / nodes;
}

/// A sheet that slides between two others, which press it.
struct Sliding {
    double middle, outer;  ///< mean speeds along x after a millisecond [m/s]
};
Sliding slide(const std::string& name, double pressure, double density, double friction) {
    LayersDeck deck;
    deck.friction = friction;
    const double h = deck.thickness;
    deck.layers = {{.z = -h, .cells = 9, .density = density},
                   {.z = 0.0, .cells = 16, .side = 0.16, .density = density},
                   {.z = h, .cells = 10, .density = density}};
    const DeckRun run(name, deck.text("a sheet that slides between two others",
                                      curve_card(1, {{0.0, 1.0}, {1.0, 1.0}}) +
                                          deck.press(0, 1, -pressure) + deck.press(2, 1, pressure) +
                                          deck.velocity(1, {20.0, 0.0, 0.0}),
                                      1e-3, 1e-4));
    REQUIRE(run.status() == 0);
    const std::size_t last = last_frame(run);
    return {layer_state(run, deck, 1, last).mean_v.x(),
            0.5 * (layer_state(run, deck, 0, last).mean_v.x() +
                   layer_state(run, deck, 2, last).mean_v.x())};
}

}  // namespace

TEST_CASE("a stack of cloth gives way as its law says, at any step", "[contact][stack]") {
    for (const int count : {20, 40}) {
        const double coarse = height_of_stack(count, 0.9), fine = height_of_stack(count, 0.2);
        CHECK(coarse == Approx(fine).epsilon(0.01));
    }
}

TEST_CASE("pressed sheets slide past each other where nothing rubs", "[contact][slide]") {
    for (const double pressure : {20e3, 100e3, 600e3}) {
        const Sliding at = slide(fmt::format("slide_{}", static_cast<int>(pressure / 1e3)),
                                 pressure, 800.0, 0.0);
        report(fmt::format("sheet between two, {} kPa [m/s]", pressure / 1e3), 20.0, at.middle);
        CHECK(at.middle == Approx(20.0).margin(0.02));
        CHECK(at.outer == Approx(0.0).margin(0.02));
    }
}

TEST_CASE("pressed sheets rub by Coulomb's law", "[contact][friction]") {
    constexpr double PRESSURE = 5e3, DENSITY = 800.0, FRICTION = 0.2;
    const Sliding at = slide("rub", PRESSURE, DENSITY, FRICTION);
    const double mass = DENSITY * 0.33e-3 * 0.16 * 0.16;
    const double impulse = 2.0 * FRICTION * PRESSURE * 0.1 * 0.1 * 1e-3;
    report("Coulomb's impulse [N s]", impulse, mass * (20.0 - at.middle));
    CHECK(mass * (20.0 - at.middle) == Approx(impulse).epsilon(0.01));
}
