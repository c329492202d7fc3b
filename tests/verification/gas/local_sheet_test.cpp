// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: fabric is pushed where the gas is: not beyond a membrane, not ahead of a front.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "io/deck.hpp"
#include "solver/simulation.hpp"
#include "tests/support/case_report.hpp"
#include "tests/support/decks/heavy_sheet.hpp"
#include "tests/support/decks/shock_tube_deck.hpp"
#include "tests/support/gas/air.hpp"
#include "tools/verify/exact/exact_riemann.hpp"

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

namespace {

/// Impulses by x since the opening of the valve, means over seeds.                       [Pa s]
struct Pushes {
    std::map<double, double> sheet;  ///< that the sheet has got
    std::map<double, double> gas;    ///< of the run's own gas a delay before, right of the membrane
};

/// Gauge impulse of sensor `k`'s gas from the opening to `until` after it, by trapezoids.
double impulse_of_gas(const DeckRun& run, const shock_tube::Tube& tube, int k, double until) {
    const auto time = run.time(), p = run.read(fmt::format("/history/cpm_sensor/{}/pressure", k));
    const double end = shock_tube::OPENS + until;
    double sum = 0.0;
    for (std::size_t i = 1; i < time.size(); ++i) {
        const double from = std::max(time[i - 1], shock_tube::OPENS), to = std::min(time[i], end);
        if (to > from) sum += (to - from) * (0.5 * (p[i - 1] + p[i]) - tube.p_outside);
    }
    return sum;
}

/// What the program says of its load.                                                        [s]
double load_delay(const shock_tube::Tube& tube) {
    const DeckFile deck("shock_sheet", shock_tube::deck(tube, shock_tube::box(true)));
    return Simulation(io::read_deck(deck.path())).bags()[0].load_delay();
}

std::vector<Pushes> pushes_of_shock(const shock_tube::Tube& tube, int seeds,
                                    const std::vector<double>& times, double delay) {
    const BoxDeck box = shock_tube::box(true);
    const double edge = box.size.x() / box.cells[0];
    std::vector<Pushes> mean(times.size());
    for (int seed = 1; seed <= seeds; ++seed) {
        const DeckRun run(fmt::format("shock_sheet_{}", seed), shock_tube::deck(tube, box),
                          fmt::format("--seed {}", seed));
        REQUIRE(run.status() == 0);
        const auto at = [&](double t) {
            return sheet::impulse(run, sheet::frame_at(run, shock_tube::OPENS + t), box.is_free);
        };
        const auto before = at(0.0);
        for (std::size_t i = 0; i < times.size(); ++i)
            for (const auto& [x, impulse] : at(times[i])) {
                mean[i].sheet[x] += (impulse - before.at(x)) / seeds;
                if (x < 0.5) continue;
                // a node between sensors k and k + 1
                const int k = static_cast<int>(std::lround((x - 0.5) / edge));
                for (const int near : {k, k + 1})
                    mean[i].gas[x] +=
                        0.5 * impulse_of_gas(run, tube, near, times[i] - delay) / seeds;
            }
    }
    return mean;
}

/// Exact gauge impulse of the tube's gas at x, `until` after the opening.                  [Pa s]
double exact_impulse(const shock_tube::Tube& tube, double x, double until) {
    const auto [left, right] = shock_tube::gases(tube);
    constexpr int STEPS = 2000;
    double sum = 0.0;
    for (int i = 0; i < STEPS && until > 0.0; ++i) {
        const double t = until * (i + 0.5) / STEPS;
        sum +=
            oracle::exact_riemann(air::GAMMA, left, right, (x - 0.5) / t).pressure - tube.p_outside;
    }
    return sum * until / STEPS;
}

/// Of the left gas at rest: the rarefaction's head runs at it.                             [m/s]
double sound_speed(const shock_tube::Tube& tube) {
    return std::sqrt(air::GAMMA * GAS_CONSTANT * tube.T_left / air::MOLAR_MASS);
}

/// Speed of the shock: of the fastest place that still differs from the right.              [m/s]
double shock_speed(const shock_tube::Tube& tube) {
    const auto [left, right] = shock_tube::gases(tube);
    double speed = 2000.0;
    while (oracle::exact_riemann(air::GAMMA, left, right, speed).pressure == right.pressure)
        speed -= 0.1;
    return speed;
}

}  // namespace

TEST_CASE("a sheet is pushed by a shock when it is there", "[sheet][front]") {
    shock_tube::Tube tube{5.0 * air::P_ATM, 300.0, air::P_ATM, 300.0, 200000, 0.6e-3};
    tube.sample = 1e-5;
    // a shock of particles is some cells of 1/60 m wide
    constexpr double WIDTH = 2.0 / 60.0, AHEAD = 0.1;
    const std::vector<double> times{0.4e-3, 0.6e-3};
    const double delay = load_delay(tube);
    const auto pushes = pushes_of_shock(tube, 8, times, delay);
    const double speed = shock_speed(tube);
    for (std::size_t i = 0; i < times.size(); ++i) {
        const double t = times[i], front = 0.5 + speed * t;
        double ahead = 0.0, n_ahead = 0.0, behind = 0.0, n_behind = 0.0, exact = 0.0, gas = 0.0;
        const std::string name = fmt::format("shock_sheet: {:.1f} ms, ", 1e3 * t);
        const double head = 0.5 - sound_speed(tube) * t;
        double still = 0.0, n_still = 0.0;
        for (const auto& [x, got] : pushes[i].sheet) {
            if (x < head - WIDTH) {
                still += got;
                n_still += 1.0;
            }
            if (x < 0.5) continue;
            const double due = exact_impulse(tube, x, t - delay), own = pushes[i].gas.at(x);
            if (x > front + WIDTH && x < front + WIDTH + AHEAD) {
                ahead += got;
                n_ahead += 1.0;
            } else if (x < front - speed * delay - WIDTH) {
                behind += got;
                exact += due;
                gas += own;
                n_behind += 1.0;
            }
            if (x < front + WIDTH + AHEAD)
                report(name + fmt::format("x - front {:+.3f} m (own gas {:.2f}) [Pa s]", x - front,
                                          own),
                       due, got);
        }
        const double share = (ahead / n_ahead) / (exact / n_behind);
        report(name + "ahead of the front, of what is behind", 0.0, share);
        report(name + "behind the front, mean [Pa s]", exact / n_behind, behind / n_behind);
        report(name + "behind the front, of the own gas's", 1.0, behind / gas);
        report(name + "left of the rarefaction, mean [Pa s]", (tube.p_left - tube.p_outside) * t,
               still / n_still);
        CHECK(std::abs(share) < 0.01);
        CHECK(still / n_still == Approx((tube.p_left - tube.p_outside) * t).epsilon(0.01));
        CHECK(behind == Approx(exact).epsilon(0.02));
    }
}
