// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include "io/results/hdf5.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/decks/layers_deck.hpp"
#include "tests/verification/contact/contact_law_setup.hpp"
#include "tools/verify/frame_crossings.hpp"

using namespace corpuscle;
using namespace corpuscle::test;
using namespace contact_law_setup;

namespace {

/// A heavy plate that flies onto a held sheet from a height: speed with which it leaves [m/s].
double rebound(double speed, double step, double height) {
    LayersDeck deck;
    deck.step = step;
    deck.layers = {{.z = 0.0, .cells = 10, .side = 0.2, .kind = Kind::HELD_CLOTH},
                   {.z = height,
                    .cells = 6,
                    .side = 0.06,
                    .kind = Kind::FREE_PLATE,
                    .density = 0.5 / (0.06 * 0.06 * deck.thickness)}};
    const std::string cards =
        fmt::format("*INITIAL_VELOCITY_RIGID_BODY\n2, 0.0, 0.0, {}\n", -speed);
    const DeckRun run(
        fmt::format("rebound_{}_{}", static_cast<int>(100 * step), static_cast<int>(1e6 * height)),
        deck.text("a plate on a held sheet", cards, 15e-3, 1e-3));
    REQUIRE(run.status() == 0);
    CHECK(verify::frame_crossings(run.results()).crossings == 0);
    return layer_state(run, deck, 1, last_frame(run)).mean_v.z();
}

}  // namespace

TEST_CASE("a plate comes back from taut cloth with its speed, at any step", "[contact][rebound]") {
    constexpr double SPEED = 5.0;
    const auto [step, height] = GENERATE(table<double, double>(
        {{0.9, 2e-3}, {0.9, 2.1e-3}, {0.9, 2.3e-3}, {0.9, 2.6e-3}, {0.45, 2e-3}, {0.2, 2e-3}}));
    const double back = rebound(SPEED, step, height);
    report(fmt::format("plate of 0.5 kg from {} mm on held cloth, TSSFAC {} [m/s]", 1e3 * height,
                       step),
           SPEED, back);
    CHECK(back == Approx(SPEED).epsilon(0.01));
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
    deck.layers = {{.z = 0.0, .cells = 10, .side = 0.2, .kind = Kind::HELD_CLOTH},
                   {.z = 60e-3, .cells = 9, .side = 0.2, .kind = Kind::HELD_CLOTH}};
    const Ball ball;
    const DeckRun run(fmt::format("bounce_{}", static_cast<int>(100 * step)),
                      deck.text("a ball between taut sheets", ball.cards(), 52e-3, 0.5e-3));
    REQUIRE(run.status() == 0);
    CHECK(verify::frame_crossings(run.results()).crossings == 0);
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
    constexpr std::size_t REBOUNDS = 2;
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

namespace {

/// Speed with which a sheet leaves that flew onto a plate, or onto `layers` on it, at 100 m/s [m/s].
double after_hit(int layers, double vdc, double step) {
    LayersDeck deck = stack(layers, step);
    deck.damping = vdc;
    deck.layers.push_back({.z = 20 * deck.thickness, .cells = 7, .side = 0.06});
    const std::size_t top = deck.layers.size() - 1;
    const DeckRun run(
        fmt::format("hit_{}_{}_{}", layers, static_cast<int>(vdc), static_cast<int>(100 * step)),
        deck.text("a sheet flies onto what lies there", deck.velocity(top, {0.0, 0.0, -100.0}),
                  1e-3, 1e-4));
    REQUIRE(run.status() == 0);
    CHECK(verify::frame_crossings(run.results()).crossings == 0);
    CHECK(run.read("/history/energy/external").back() < 1e-6);
    return layer_state(run, deck, top, last_frame(run)).mean_v.z();
}

}  // namespace

TEST_CASE("a sheet at 100 m/s comes back as its energy says, at any step", "[contact][impact]") {
    // With a dashpot, and from a stack: near what TSSFAC .005 gives, 38, 70, 15
    const auto [layers, vdc, exact, tolerance] = GENERATE(table<int, double, double, double>(
        {{0, 0.0, 100.0, 0.1}, {0, 20.0, 32.0, 0.4}, {10, 0.0, 65.0, 0.5}, {10, 20.0, 15.0, 0.4}}));
    for (const double step : {0.9, 0.45, 0.2}) {
        const double back = after_hit(layers, vdc, step);
        report(fmt::format("sheet at 100 m/s on {} layers, VDC {}, TSSFAC {}: speed after [m/s]",
                           layers, vdc, step),
               exact, back);
        CHECK(back == Approx(exact).epsilon(tolerance));
    }
}
