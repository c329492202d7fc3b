// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include "io/results/hdf5.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/decks/layers_deck.hpp"
#include "tools/verify/frame_crossings.hpp"

namespace contact_law_setup {

using namespace corpuscle;
using namespace corpuscle::test;

/// Modulus through the thickness over that in the plane [DESIGN: the law of contact].
inline constexpr double THROUGH = 1.0 / 30.0;

using Kind = Layer::Kind;

/// Curve 1: up to 1 within half a millisecond.
inline std::string ramp() {
    return curve_card(1, {{0.0, 0.0}, {0.5e-3, 1.0}, {1.0, 1.0}});
}

/// Layers on a plate, with meshes that do not fit each other.
inline LayersDeck stack(int count, double step) {
    LayersDeck deck;
    deck.step = step;
    deck.layers.push_back({.z = 0.0, .cells = 4, .side = 0.12, .kind = Kind::FIXED_PLATE});
    for (int l = 1; l <= count; ++l)
        deck.layers.push_back({.z = l * deck.thickness, .cells = 6 + l % 3, .side = 0.08});
    return deck;
}

inline double height_of_stack(int count, double step) {
    constexpr double PRESSURE = 200e3;
    const LayersDeck deck = stack(count, step);
    const std::size_t top = deck.layers.size() - 1;
    const DeckRun run(
        fmt::format("stack_{}_{}", count, static_cast<int>(100 * step)),
        deck.text("layers on a plate", ramp() + deck.press(top, 1, PRESSURE), 3e-3, 1e-3));
    REQUIRE(run.status() == 0);
    double sum = 0.0, nodes = 0.0;
    for (const Vec3& x : layer_state(run, deck, top, last_frame(run)).x) {
        if (std::max(std::abs(x.x()), std::abs(x.y())) > 0.025) continue;
        sum += x.z();
        nodes += 1.0;
    }
    const double way = count - 1.0, E = THROUGH * deck.modulus;
    const double exact =
        deck.thickness * (way / (1.0 + PRESSURE / E) + 1.0 / (1.0 + 0.5 * PRESSURE / E));
    report(fmt::format("height of {} layers, TSSFAC {} [mm]", count, step), 1e3 * exact,
           1e3 * sum / nodes);
    CHECK(sum / nodes == Approx(exact).epsilon(0.01));
    return sum / nodes;
}

/// A sheet that slides between two others, which press it.
struct Sliding {
    double middle, outer;  ///< mean speeds along x after a millisecond [m/s]
};
inline Sliding slide(const std::string& name, double pressure, double density, double friction) {
    LayersDeck deck;
    deck.friction = friction;
    const double h = deck.thickness;
    deck.layers = {{.z = -h, .cells = 9, .density = density},
                   {.z = 0.0, .cells = 16, .side = 0.16, .density = density},
                   {.z = h, .cells = 10, .density = density}};
    const DeckRun run(
        name, deck.text("a sheet that slides between two others",
                        curve_card(1, {{0.0, 1.0}, {1.0, 1.0}}) + deck.press(0, 1, -pressure) +
                            deck.press(2, 1, pressure) + deck.velocity(1, {20.0, 0.0, 0.0}),
                        1e-3, 1e-4));
    REQUIRE(run.status() == 0);
    const std::size_t last = last_frame(run);
    return {layer_state(run, deck, 1, last).mean_v.x(),
            0.5 * (layer_state(run, deck, 0, last).mean_v.x() +
                   layer_state(run, deck, 2, last).mean_v.x())};
}

}  // namespace contact_law_setup
