// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: layers of cloth give way under pressure as their law says, slide as friction says, and
// neither depends on the time step.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "contact/geometry/distance.hpp"
#include "io/results/hdf5.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/decks/layers_deck.hpp"
#include "tests/verification/contact/contact_law_setup.hpp"
#include "tools/verify/frame_crossings.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using namespace contact_law_setup;

TEST_CASE("a stack of cloth gives way as its law says, at any step", "[contact][stack]") {
    for (const int count : {20, 40}) {
        const double coarse = height_of_stack(count, 0.9), fine = height_of_stack(count, 0.2);
        CHECK(coarse == Approx(fine).epsilon(0.01));
    }
}

void slide_freely(double pressure) {
    const Sliding at =
        slide(fmt::format("slide_{}", static_cast<int>(pressure / 1e3)), pressure, 800.0, 0.0);
    report(fmt::format("sheet between two, {} kPa [m/s]", pressure / 1e3), 20.0, at.middle);
    CHECK(at.middle == Approx(20.0).margin(0.02));
    CHECK(at.outer == Approx(0.0).margin(0.02));
}

TEST_CASE("pressed sheets slide past each other where nothing rubs", "[contact][slide]") {
    slide_freely(20e3);
    slide_freely(100e3);
    slide_freely(600e3);
}

TEST_CASE("sheets at rest between equal pressures of six bars stay where they are",
          "[contact][flat]") {
    constexpr double PRESSURE = 600e3;
    LayersDeck deck;
    const double h = deck.thickness;
    deck.layers = {
        {.z = -h, .cells = 20}, {.z = 0.0, .cells = 32, .side = 0.16}, {.z = h, .cells = 20}};
    const DeckRun run(
        "flat", deck.text("a sheet between two others",
                          curve_card(1, {{0.0, 1.0}, {1.0, 1.0}}) + deck.press(0, 1, -PRESSURE) +
                              deck.press(2, 1, PRESSURE),
                          1e-3, 1e-4));
    REQUIRE(run.status() == 0);
    const LayerState lower = layer_state(run, deck, 0, last_frame(run)),
                     upper = layer_state(run, deck, 2, last_frame(run));
    const double gap = h / (1.0 + PRESSURE / (THROUGH * deck.modulus));
    const double height = upper.mean_x.z() - lower.mean_x.z();
    report("two sheets on one under six bars [mm]", 2e3 * gap, 1e3 * height);
    CHECK(height == Approx(2.0 * gap).epsilon(0.01));
    double square = 0.0;
    for (const Vec3& x : lower.x) square += std::pow(x.z() - lower.mean_x.z(), 2);
    const double rough = std::sqrt(square / static_cast<double>(lower.x.size()));
    report("how far they leave their plane, RMS [mm]", 0.0, 1e3 * rough);
    CHECK(rough < 0.1 * h);
}

TEST_CASE("pressed sheets rub by Coulomb's law", "[contact][friction]") {
    constexpr double PRESSURE = 5e3, DENSITY = 800.0, FRICTION = 0.2;
    const Sliding at = slide("rub", PRESSURE, DENSITY, FRICTION);
    const double mass = DENSITY * 0.33e-3 * 0.16 * 0.16;
    const double impulse = 2.0 * FRICTION * PRESSURE * 0.1 * 0.1 * 1e-3;
    report("Coulomb's impulse [N s]", impulse, mass * (20.0 - at.middle));
    CHECK(mass * (20.0 - at.middle) == Approx(impulse).epsilon(0.01));
}

namespace {

/// Mean distance of a layer's nodes from another layer, wherever both have gone: free sheets bend as
/// they like.                                                                              [m]
double mean_distance(const LayerState& of, const LayerState& from, int cells) {
    double sum = 0.0;
    for (const Vec3& p : of.x) {
        double least = INF;
        const auto at = [&](int i, int j) -> const Vec3& { return from.x[j * (cells + 1) + i]; };
        const auto meet = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
            const Vec3 foot = contact::foot_on_triangle(p, a, b, c);
            least = std::min(least, (foot[0] * a + foot[1] * b + foot[2] * c - p).norm());
        };
        for (int j = 0; j < cells; ++j)
            for (int i = 0; i < cells; ++i) {
                meet(at(i, j), at(i + 1, j), at(i + 1, j + 1));
                meet(at(i, j), at(i + 1, j + 1), at(i, j + 1));
            }
        sum += least;
    }
    return sum / static_cast<double>(of.x.size());
}

}  // namespace

TEST_CASE("layers that coincide at the start part without a kick, and cross nowhere",
          "[contact][coincide]") {
    constexpr double PRESSURE = 20e3;
    const int count = GENERATE(2, 4);
    const bool is_alike = GENERATE(true, false);
    LayersDeck deck;
    std::string cards = curve_card(1, {{0.0, 0.0}, {1e-4, 1.0}, {1.0, 1.0}});
    for (int l = 0; l < count; ++l) deck.layers.push_back({.cells = is_alike ? 8 : 7 + l});
    cards += deck.press(0, 1, -PRESSURE);
    cards += deck.press(deck.layers.size() - 1, 1, PRESSURE);
    const DeckRun run(fmt::format("coincide_{}_{}", count, is_alike),
                      deck.text("layers in one place", cards, 6e-3, 2e-4));
    REQUIRE(run.status() == 0);
    CHECK(verify::frame_crossings(run.results()).crossings == 0);
    const std::size_t last = last_frame(run);
    const double exact = (count - 1) * deck.thickness / (1.0 + PRESSURE / (THROUGH * deck.modulus));
    const double height = mean_distance(layer_state(run, deck, deck.layers.size() - 1, last),
                                        layer_state(run, deck, 0, last), deck.layers.front().cells);
    report(fmt::format("{} layers from one place, meshes {} [mm]", count,
                       is_alike ? "alike" : "not alike"),
           1e3 * exact, 1e3 * height);
    CHECK(height == Approx(exact).epsilon(0.02));  // the thickness has come back but for exp(-4.5)
    // parting is work against the pressure, which comes from outside: contact never had it
    const io::Hdf5Reader results(run.results());
    for (const double energy : results.read<double>("/history/energy/contact"))
        CHECK(energy >= 0.0);
    const double pressed = PRESSURE * deck.layers[0].side * deck.layers[0].side * height;
    CHECK(std::abs(results.read<double>("/history/energy/external").back()) < 0.1 * pressed);
}

namespace {

/// A sheet between a plate and another sheet, which rub on it.
LayersDeck sheets_on_plate() {
    LayersDeck deck;
    deck.friction = 0.3;
    deck.layers = {{.z = -deck.thickness, .cells = 9, .side = 0.12, .kind = Kind::FIXED_PLATE},
                   {.z = 0.0, .cells = 8},
                   {.z = deck.thickness, .cells = 7, .side = 0.06}};
    return deck;
}

}  // namespace

TEST_CASE("a sheet held along x and y stays there, whatever slides over it", "[contact][held]") {
    const LayersDeck deck = sheets_on_plate();
    const auto held = deck.ids(1);
    std::string cards = curve_card(1, {{0.0, 1.0}, {1.0, 1.0}}) + deck.press(2, 1, 50e3) +
                        deck.velocity(2, {10.0, 5.0, 0.0}) + "*SET_NODE_LIST_GENERATE\n7\n";
    cards += fmt::format("{}, {}\n*BOUNDARY_SPC_SET\n7, 0, 1, 1, 0, 0, 0, 0\n", held.node,
                         held.node_end - 1);
    const DeckRun run("held_in_plane", deck.text("a sheet held in its plane", cards, 1e-3, 1e-4));
    REQUIRE(run.status() == 0);
    const LayerState first = layer_state(run, deck, 1, 0),
                     last = layer_state(run, deck, 1, last_frame(run));
    for (std::size_t n = 0; n < last.x.size(); ++n) {
        CHECK(last.x[n].x() == first.x[n].x());
        CHECK(last.x[n].y() == first.x[n].y());
    }
    CHECK(layer_state(run, deck, 2, last_frame(run)).mean_v.x() < 9.0);  // it was rubbed
}

TEST_CASE("a sheet that is led moves as it is told, whatever rubs on it", "[contact][held]") {
    const LayersDeck deck = sheets_on_plate();
    const auto led = deck.ids(1);
    std::string cards = curve_card(1, {{0.0, 1.0}, {1.0, 1.0}}) +
                        curve_card(2, {{0.0, 5.0}, {1.0, 5.0}}) + deck.press(2, 1, 50e3) +
                        "*SET_NODE_LIST_GENERATE\n7\n";
    cards += fmt::format("{}, {}\n*BOUNDARY_PRESCRIBED_MOTION_SET\n7, 1, 0, 2, 1.0\n", led.node,
                         led.node_end - 1);
    const DeckRun run("led", deck.text("a sheet that is led", cards, 1e-3, 1e-4));
    REQUIRE(run.status() == 0);
    const LayerState first = layer_state(run, deck, 1, 0),
                     last = layer_state(run, deck, 1, last_frame(run));
    for (std::size_t n = 0; n < last.x.size(); ++n)
        CHECK(last.x[n].x() - first.x[n].x() == Approx(5e-3).epsilon(1e-5));
}

TEST_CASE("layers that are pressed on a rigid wall do not enter it", "[contact][wall]") {
    LayersDeck deck;
    for (int l = 0; l < 5; ++l)
        deck.layers.push_back({.z = (l + 0.5) * deck.thickness, .cells = 6 + l % 3, .side = 0.08});
    const std::string cards = ramp() + deck.press(4, 1, 200e3) +
                              "*RIGIDWALL_PLANAR\n0, 0\n0.0, 0.0, 0.0, 0.0, 0.0, 1.0\n";
    const DeckRun run("on_wall", deck.text("layers on a rigid wall", cards, 2e-3, 1e-4));
    REQUIRE(run.status() == 0);
    double least = INF;
    for (std::size_t frame = 0; frame <= last_frame(run); ++frame)
        for (std::size_t l = 0; l < deck.layers.size(); ++l)
            for (const Vec3& x : layer_state(run, deck, l, frame).x) least = std::min(least, x.z());
    report("lowest node over a rigid wall [mm]", 0.0, 1e3 * least);
    CHECK(least > -1e-9);
    CHECK(layer_state(run, deck, 4, last_frame(run)).mean_x.z() > 3.9 * deck.thickness);
}
