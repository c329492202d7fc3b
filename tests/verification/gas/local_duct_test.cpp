// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: a vent lets out the gas that is there: none before a wave has come through the duct, then
// what the 1-D Euler equations say.
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include "tests/support/case_report.hpp"
#include "tests/support/decks/box_deck.hpp"
#include "tests/support/gas/air.hpp"
#include "tests/support/runs/deck_run.hpp"
#include "tools/verify/exact/euler_duct.hpp"
#include "tools/verify/exact/stirred_tank.hpp"

using namespace corpuscle;
using namespace corpuscle::test;

namespace {

constexpr double LENGTH = 1.0, AREA = 0.01;      ///< of the duct                 [m], [m^2]
constexpr double DUCT_RATE = 5.0, UNTIL = 1e-3;  ///< of the inflow               [kg/s], [s]
constexpr double T_AIR = 300.0;                  ///< of the air; the inflow's stagnation [K]
constexpr double DUCT_END = 6e-3;                ///< [s]
enum Part { WALL = 1, INLET = 2, VENT = 3 };

/// Air at rest in a duct; the end at x = 0 blows, that at x = 1 m is the vent.
std::string duct(int particles) {
    BoxDeck box;
    box.size = {LENGTH, 0.1, 0.1};
    box.cells = {60, 6, 6};
    box.part = [](const Vec3& x) {
        return x.x() < 1e-9 ? INLET : x.x() > LENGTH - 1e-9 ? VENT : WALL;
    };
    std::string cards, nozzles;
    for (const int part : {WALL, INLET, VENT}) cards += part_card(part, 1);
    cards += section_card(1, 1e-3) + "*MAT_NULL\n1, 1000.0\n" + set_card(12, {WALL, INLET, VENT});
    const DeckMesh mesh = box.mesh();
    int count = 0;
    for (std::size_t e = 0; e < mesh.quads.size(); ++e)
        if (mesh.quads[e].part == INLET) {  // along the shell's normal, inward
            nozzles += fmt::format("{}, 1.0, -1\n", e + 1);
            ++count;
        }
    cards += curve_card(1, {{0.0, DUCT_RATE}, {UNTIL, DUCT_RATE}, {UNTIL, 0.0}, {1.0, 0.0}});
    cards += curve_card(2, {{0.0, T_AIR / air::GAMMA}, {1.0, T_AIR / air::GAMMA}});
    cards += fmt::format(
        "*AIRBAG_PARTICLE\n12, 1\n{}, 1, 3, {}, {}, 1\n2, 1, {}\n{}, 0, 1.0, 0, 0, 1\n"
        "{}, {}, {}, {}\n1, 2, {}, {}\n",
        particles, T_AIR, air::P_ATM, count, static_cast<int>(VENT), air::P_ATM, T_AIR,
        air::MOLAR_MASS, air::MOLAR_CP, air::MOLAR_MASS, air::MOLAR_CP);
    return box_deck("duct", box, cards + nozzles, DUCT_END, 5e-5);
}

/// Mass that has left at each time.                                                        [kg]
std::vector<double> exact_outflow(const std::vector<double>& time, double jet_share) {
    const oracle::Gas1D rest{air::density(air::P_ATM, T_AIR), 0.0, air::P_ATM};
    oracle::EulerDuct duct(air::GAMMA, LENGTH, 400, rest, air::P_ATM, 0.02);
    // a jet has sqrt(3 R T / M), T of the gas at rest, spread evenly over a cone of 30 degrees
    const double speed = std::sqrt(3.0 * GAS_CONSTANT * T_AIR / air::MOLAR_MASS);
    const double along = 0.5 * (1.0 + std::cos(std::acos(-1.0) / 6.0));
    const double flux = DUCT_RATE / AREA;
    const oracle::DuctInflow on{flux, jet_share * flux * speed * along, flux * air::energy(T_AIR)};
    std::vector<double> out;
    for (const double t : time) {
        duct.advance(std::min(t, UNTIL), on);
        duct.advance(t, {0.0, 0.0, 0.0});
        out.push_back(duct.mass_out() * AREA);
    }
    return out;
}

}  // namespace

TEST_CASE("the duct's equations keep mass and energy, and end in Wang and Nefske's flow",
          "[duct][oracle]") {
    const double rate = GENERATE(200.0, 400.0, 600.0);  // [kg/(m^2 s)]; the last one is choked
    const oracle::Gas1D rest{air::density(air::P_ATM, T_AIR), 0.0, air::P_ATM};
    oracle::EulerDuct duct(air::GAMMA, LENGTH, 100, rest, air::P_ATM, 0.02);
    const oracle::DuctInflow inflow{rate, 0.0, rate * air::energy(T_AIR)};
    const double mass = duct.mass(), energy = duct.energy();
    constexpr double STEADY = 60e-3;
    duct.advance(STEADY, inflow);
    CHECK(duct.mass() + duct.mass_out() == Approx(mass + rate * STEADY).epsilon(1e-10));
    CHECK(duct.energy() + duct.energy_out() ==
          Approx(energy + inflow.energy * STEADY).epsilon(1e-10));
    const oracle::Gas1D last = duct.gas().back();
    const double static_T = last.pressure * air::MOLAR_MASS / (last.density * GAS_CONSTANT);
    const double stagnation_T =
        static_T + 0.5 * last.velocity * last.velocity * air::MOLAR_MASS / air::MOLAR_CP;
    const double stagnation_p =
        last.pressure * std::pow(stagnation_T / static_T, air::GAMMA / (air::GAMMA - 1.0));
    CHECK(oracle::nozzle_flux(stagnation_p, stagnation_T, air::MOLAR_MASS, air::MOLAR_CP,
                              air::P_ATM) == Approx(rate).epsilon(0.01));
}

TEST_CASE("a vent at the end of a duct waits for the gas", "[duct][vent]") {
    const DeckRun run("duct", duct(100000));
    REQUIRE(run.status() == 0);
    const auto time = run.time(), out = run.read("/history/airbag/1/mass_out_vent");
    const auto exact = exact_outflow(time, 1.0), no_jets = exact_outflow(time, 0.0);
    double worst = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        worst = std::max(worst, std::abs(out[i] - exact[i]));
        if (i % 10 == 0)
            report(fmt::format("duct: out at {:.1f} ms [g]", 1e3 * time[i]), 1e3 * exact[i],
                   1e3 * out[i]);
    }
    report("duct: curve off by, at worst, of the final value", 0.0, worst / exact.back());
    // the jets' momentum is taken by the wall behind them
    CHECK(no_jets.back() == Approx(exact.back()).epsilon(0.02));
    CHECK(worst < 0.08 * exact.back());
}

TEST_CASE("nothing leaves a duct before a wave has come to its vent", "[duct][vent]") {
    constexpr int DRAWS = 4;
    double mean = 0.0;
    for (int seed = 1; seed <= DRAWS; ++seed) {
        const DeckRun run("duct", duct(100000), fmt::format("--seed {} --until 1e-3", seed));
        REQUIRE(run.status() == 0);
        mean += run.read("/history/airbag/1/mass_out_vent").back() / DRAWS;
    }
    report("duct: out at 1 ms, mean of four draws [g]", 0.0, 1e3 * mean);
    CHECK(mean < 2e-5);
}
