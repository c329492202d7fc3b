// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: fabric is pushed where the gas is: not beyond a membrane, not ahead of a front.
#include <catch2/catch.hpp>

#include "tests/support/air.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/exact_riemann.hpp"
#include "tests/support/heavy_sheet.hpp"
#include "tests/support/shock_tube_deck.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

/// Rooms of a litre, A of 5 atmospheres by 0.1 ms and B empty; nothing outside.
std::string one_full_room(const BoxDeck& box) {
    constexpr double IN = 1e-4, T = 300.0;
    const double rate = air::density(5.0 * air::P_ATM, T) * 1e-3 / IN;
    std::string cards = part_card(1, 1, 1) + part_card(2, 1, 1) + part_card(3, 2, 1) +
                        section_card(1, sheet::THICKNESS) + set_card(12, {1, 2, 3});
    cards += "*MAT_NULL\n1, 1000.0\n";
    cards += fmt::format("*MAT_NULL\n2, {}\n", sheet::DENSITY);
    cards += node_card(100001, {0.05, 0.05, 0.05});
    cards += curve_card(1, {{0.0, rate}, {IN, rate}, {IN, 0.0}, {1.0, 0.0}}) +
             curve_card(2, {{0.0, T / air::GAMMA}, {1.0, T / air::GAMMA}});
    cards += fmt::format(
        "*AIRBAG_PARTICLE\n12, 1, 2, 0\n20000, 1, 3, 300.0, 1.0\n0, 1, 1\n1, 2, {}, {}\n"
        "100001, 1.0\n",
        air::MOLAR_MASS, air::MOLAR_CP);
    cards += "*DATABASE_BINARY_D3PLOT\n5e-4\n";
    return box_deck("a full and an empty room", box, cards, 2e-3, 5e-5);
}

}  // namespace

TEST_CASE("a sheet is not pushed beyond a membrane", "[sheet][membrane]") {
    BoxDeck box;
    box.size = {0.2, 0.1, 0.1};
    box.cells = {24, 12, 12};
    box.membranes = {{12, 2}};
    box.part = [](const Vec3& x) { return x.z() > 0.1 - 1e-9 ? 3 : 1; };
    box.is_free = sheet::is_free(box.size, 0.1);
    const DeckRun run("beyond_membrane", one_full_room(box));
    REQUIRE(run.status() == 0);
    for (const double time : {0.5e-3, 2e-3}) {
        double a = 0.0, nodes = 0.0;
        std::vector<double> b;
        for (const auto& [x, impulse] :
             sheet::impulse(run, sheet::frame_at(run, time), box.is_free)) {
            if (x < 0.1) {
                a += impulse;
                nodes += 1.0;
            } else {
                b.push_back(impulse);
            }
        }
        a /= nodes;
        REQUIRE(a > 0.0);
        for (std::size_t row = 0; row < b.size(); ++row) {
            if (row < 5)
                report(fmt::format("beyond_membrane: row {} beyond, {} ms, of A's impulse", row + 1,
                                   1e3 * time),
                       0.0, b[row] / a);
            CHECK(std::abs(b[row]) < 0.005 * a);
        }
    }
}

TEST_CASE("a sheet is pushed by a shock when it is there", "[sheet][front]") {
    using shock_tube::OPENS;
    const shock_tube::Tube tube{5.0 * air::P_ATM, 300.0, air::P_ATM, 300.0, 200000, 0.8e-3};
    const BoxDeck box = shock_tube::box(true);
    const DeckRun run("shock_sheet", shock_tube::deck(tube, box));
    REQUIRE(run.status() == 0);

    const oracle::Gas1D left{air::density(tube.p_left, tube.T_left), 0.0, tube.p_left},
        right{air::density(tube.p_right, tube.T_right), 0.0, tube.p_right};
    // the shock: the fastest place that still differs from the right
    double shock = 0.0;
    for (double speed = 0.0; speed < 2000.0; speed += 0.1)
        if (oracle::exact_riemann(air::GAMMA, left, right, speed).pressure > right.pressure)
            shock = speed;
    constexpr double DELAY = 5e-5;  // the load's smoothing
    const auto exact_impulse = [&](double x, double until) {
        constexpr int STEPS = 2000;
        double sum = 0.0;
        for (int i = 0; i < STEPS && until > 0.0; ++i) {
            const double t = until * (i + 0.5) / STEPS;
            sum +=
                oracle::exact_riemann(air::GAMMA, left, right, (x - 0.5) / t).pressure - air::P_ATM;
        }
        return sum * until / STEPS;
    };
    const auto before = sheet::impulse(run, sheet::frame_at(run, OPENS), box.is_free);
    for (const double t : {0.4e-3, 0.6e-3}) {
        const double front = 0.5 + shock * t;
        const auto after = sheet::impulse(run, sheet::frame_at(run, OPENS + t), box.is_free);
        double ahead = 0.0, n_ahead = 0.0, behind = 0.0, n_behind = 0.0, exact = 0.0;
        // a shock of particles is some cells of 1/60 m wide
        constexpr double WIDTH = 2.0 / 60.0;
        for (const auto& [x, impulse] : after) {
            if (x < 0.5) continue;
            const double got = impulse - before.at(x), due = exact_impulse(x, t - DELAY);
            if (x > front + WIDTH) {
                ahead += got;
                n_ahead += 1.0;
            } else if (x < front - shock * DELAY - WIDTH && x > 0.5 + WIDTH) {
                behind += got;
                exact += due;
                n_behind += 1.0;
            }
            report(fmt::format("shock_sheet: {:.1f} ms, x - front = {:+.3f} m [Pa s]", 1e3 * t,
                               x - front),
                   due, got);
        }
        REQUIRE(n_behind > 3.0);
        REQUIRE(n_ahead > 3.0);
        const double share = (ahead / n_ahead) / (exact / n_behind);
        report(
            fmt::format("shock_sheet: {:.1f} ms, ahead of the front, of what is behind", 1e3 * t),
            0.0, share);
        report(fmt::format("shock_sheet: {:.1f} ms, behind the front [Pa s]", 1e3 * t),
               exact / n_behind, behind / n_behind);
        CHECK(std::abs(share) < 0.01);
        CHECK(behind == Approx(exact).epsilon(0.02));
    }
}
