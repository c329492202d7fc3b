// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: layers of cloth give way under pressure as their law says, slide as friction says, and
// neither depends on the time step.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <map>

#include "io/results/hdf5.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/decks/layers_deck.hpp"
#include "tests/support/runs/frame_crossings.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Modulus through the thickness over that in the plane [DESIGN: the law of contact].
constexpr double THROUGH = 1.0 / 30.0;

using Kind = Layer::Kind;

/// Curve 1: up to 1 within half a millisecond.
std::string ramp() {
    return curve_card(1, {{0.0, 0.0}, {0.5e-3, 1.0}, {1.0, 1.0}});
}

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
Sliding slide(const std::string& name, double pressure, double density, double friction) {
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

}  // namespace

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
}

// 19.9 m/s so far
TEST_CASE("sheets pressed by six bars slide past each other likewise", "[.full][contact][slide]") {
    slide_freely(600e3);
}

TEST_CASE("pressed sheets rub by Coulomb's law", "[contact][friction]") {
    constexpr double PRESSURE = 5e3, DENSITY = 800.0, FRICTION = 0.2;
    const Sliding at = slide("rub", PRESSURE, DENSITY, FRICTION);
    const double mass = DENSITY * 0.33e-3 * 0.16 * 0.16;
    const double impulse = 2.0 * FRICTION * PRESSURE * 0.1 * 0.1 * 1e-3;
    report("Coulomb's impulse [N s]", impulse, mass * (20.0 - at.middle));
    CHECK(mass * (20.0 - at.middle) == Approx(impulse).epsilon(0.01));
}

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
    CHECK(frame_crossings(run.results()).crossings == 0);
    const std::size_t last = last_frame(run);
    const double exact = (count - 1) * deck.thickness / (1.0 + PRESSURE / (THROUGH * deck.modulus));
    const double height = std::abs(layer_state(run, deck, deck.layers.size() - 1, last).mean_x.z() -
                                   layer_state(run, deck, 0, last).mean_x.z());
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

namespace {

/// A heavy plate that flies onto a held sheet: speed with which it leaves [m/s].
double rebound(double speed, double step) {
    LayersDeck deck;
    deck.step = step;
    deck.layers = {{.z = 0.0, .cells = 16, .side = 0.2, .kind = Kind::HELD_CLOTH},
                   {.z = 2e-3,
                    .cells = 6,
                    .side = 0.06,
                    .kind = Kind::FREE_PLATE,
                    .density = 0.5 / (0.06 * 0.06 * deck.thickness)}};
    const std::string cards =
        fmt::format("*INITIAL_VELOCITY_RIGID_BODY\n2, 0.0, 0.0, {}\n", -speed);
    const DeckRun run(fmt::format("rebound_{}", static_cast<int>(100 * step)),
                      deck.text("a plate on a held sheet", cards, 15e-3, 1e-3));
    REQUIRE(run.status() == 0);
    CHECK(frame_crossings(run.results()).crossings == 0);
    return layer_state(run, deck, 1, last_frame(run)).mean_v.z();
}

}  // namespace

TEST_CASE("a plate comes back from taut cloth with its speed, at any step", "[contact][rebound]") {
    constexpr double SPEED = 5.0;
    for (const double step : {0.9, 0.45, 0.2}) {
        const double back = rebound(SPEED, step);
        report(fmt::format("plate of 0.5 kg on held cloth, TSSFAC {} [m/s]", step), SPEED, back);
        CHECK(back == Approx(SPEED).epsilon(0.01));
    }
}

namespace {

/// A rigid ball that flies down between two layers: a cube's grid blown up, part 99, ids from FIRST.
struct Ball {
    static constexpr int CELLS = 6, FIRST = 100001, PART = 99;
    double radius = 20e-3, mass = 0.5, height = 30e-3, speed = 5.0;

    [[nodiscard]] std::string cards() const {
        constexpr double QUARTER = 0.78539816339744831, THICKNESS = 1e-3;
        std::map<std::array<int, 3>, int> ids;
        std::string nodes = "*NODE\n", shells = "*ELEMENT_SHELL\n";
        const auto id_of = [&](const std::array<int, 3>& on) {
            const auto [at, is_new] = ids.try_emplace(on, FIRST + static_cast<int>(ids.size()));
            if (is_new) {
                Vec3 x;
                for (int k = 0; k < 3; ++k) x[k] = std::tan(QUARTER * (2.0 * on[k] / CELLS - 1.0));
                x = radius * x.normalized() + Vec3(0.0, 0.0, height);
                nodes +=
                    fmt::format("{}, {:.9g}, {:.9g}, {:.9g}\n", at->second, x.x(), x.y(), x.z());
            }
            return at->second;
        };
        int shell = FIRST;
        for (int face = 0; face < 6; ++face)
            for (int i = 0; i < CELLS; ++i)
                for (int j = 0; j < CELLS; ++j) {
                    std::string corners;
                    for (const auto& [di, dj] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                        std::array<int, 3> on{};
                        on[face / 2] = face % 2 * CELLS;
                        on[(face / 2 + 1) % 3] = i + di;
                        on[(face / 2 + 2) % 3] = j + dj;
                        corners += fmt::format(", {}", id_of(on));
                    }
                    shells += fmt::format("{}, {}{}\n", shell++, PART, corners);
                }
        const double area = 16.0 * QUARTER * radius * radius;
        return nodes + shells + part_card(PART, PART, PART) + section_card(PART, THICKNESS) +
               fmt::format("*MAT_RIGID\n{}, {}, 2.1e11, 0.3\n0, 0, 0\n\n", PART,
                           mass / (area * THICKNESS)) +
               fmt::format("*INITIAL_VELOCITY_RIGID_BODY\n{}, 0.0, 0.0, {}\n", PART, -speed);
    }
};

/// Speeds with which a ball between two held sheets passes half-way, after each rebound [m/s].
std::vector<double> bounce(double step) {
    LayersDeck deck;
    deck.step = step;
    deck.layers = {{.z = 0.0, .cells = 16, .side = 0.2, .kind = Kind::HELD_CLOTH},
                   {.z = 60e-3, .cells = 15, .side = 0.2, .kind = Kind::HELD_CLOTH}};
    const Ball ball;
    const DeckRun run(fmt::format("bounce_{}", static_cast<int>(100 * step)),
                      deck.text("a ball between taut sheets", ball.cards(), 75e-3, 0.5e-3));
    REQUIRE(run.status() == 0);
    CHECK(frame_crossings(run.results()).crossings == 0);
    std::vector<double> speeds;
    const std::size_t first = deck.ids(1).node_end - 1;
    double last = 0.0;
    for (std::size_t frame = 0; frame <= last_frame(run); ++frame) {
        const auto x = run.read(fmt::format("/frames/{:05}/coordinates", frame));
        const auto v = run.read(fmt::format("/frames/{:05}/velocity", frame));
        double z = 0.0, speed = 0.0;
        for (std::size_t n = 3 * first + 2; n < x.size(); n += 3) {
            z += x[n];
            speed += v[n];
        }
        const double count = static_cast<double>(x.size() / 3 - first);
        const double off = z / count - ball.height;
        if (off * last < 0.0) speeds.push_back(std::abs(speed / count));
        if (std::abs(off) > 1e-3) last = off;
    }
    return speeds;
}

}  // namespace

TEST_CASE("a ball bounces between taut sheets alike, at any step", "[contact][rebound]") {
    constexpr std::size_t REBOUNDS = 3;
    std::vector<double> before;
    for (const double step : {0.9, 0.45, 0.2}) {
        const std::vector<double> speeds = bounce(step);
        REQUIRE(speeds.size() >= REBOUNDS);
        for (std::size_t k = 0; k < REBOUNDS; ++k) {
            report(fmt::format("ball between sheets, TSSFAC {}, rebound {} [m/s]", step, k + 1),
                   5.0, speeds[k]);
            CHECK(speeds[k] > 0.9 * 5.0);
            if (!before.empty()) CHECK(speeds[k] == Approx(before[k]).epsilon(0.01));
        }
        if (before.empty()) before = speeds;
    }
}

TEST_CASE("a sheet at 100 m/s is stopped by a stack, at any step", "[contact][impact]") {
    for (const double step : {0.9, 0.45, 0.2}) {
        LayersDeck deck = stack(10, step);
        const double h = deck.thickness;
        deck.layers.push_back({.z = 20 * h, .cells = 7, .side = 0.06});
        const std::size_t top = deck.layers.size() - 1;
        const DeckRun run(fmt::format("impact_{}", static_cast<int>(100 * step)),
                          deck.text("a sheet flies onto a stack",
                                    deck.velocity(top, {0.0, 0.0, -100.0}), 2e-3, 1e-4));
        REQUIRE(run.status() == 0);
        CHECK(frame_crossings(run.results()).crossings == 0);
        const double back = layer_state(run, deck, top, last_frame(run)).mean_v.z();
        report(fmt::format("sheet at 100 m/s on ten layers, TSSFAC {}: speed after [m/s]", step),
               0.0, back);
        CHECK(back > 0.0);
        CHECK(back < 100.0);  // what the layers give back grows as the step shrinks
    }
}
