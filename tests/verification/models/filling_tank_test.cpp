// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: an inflator that fires into a closed tank of air gives the pressure of a mixed tank at all
// times, with and without heat through its walls.

#include <catch2/catch.hpp>

#include <string>

#include "solver/base/curve.hpp"
#include "tests/support/runs/model_run.hpp"
#include "tools/verify/exact/filling_tank.hpp"

using namespace corpuscle;
using corpuscle::test::ModelRun;

namespace {

// models/tank_test: kg, mm, ms, K
constexpr double VOLUME = 60.0e6, T_ATM = 293.0, P_ATM = 1.01325e-4, MOLAR_MASS = 0.0285;
const oracle::IdealGas AIR{29.1, 0.0}, PRODUCTS{27.0, 0.0056};

Curve curve(std::vector<double> x, std::vector<double> y) {
    Curve made;
    made.x = std::move(x);
    made.y = std::move(y);
    return made;
}

const Curve MASS_FLOW =
    curve({0, 1, 7, 12, 20, 30, 40, 40}, {0, 0.5e-3, 1.6e-3, 1.5e-3, 0.9e-3, 0.45e-3, 0.1e-3, 0});
const Curve TEMPERATURE = curve({0, 1, 7, 12, 20, 30, 40}, {700, 750, 800, 800, 720, 640, 600});

}  // namespace

TEST_CASE("an inflator fills a tank to the pressure of a mixed tank", "[models]") {
    // initial air as particles or not; heat to the wall
    const auto [air, heat] = GENERATE(std::pair(2, 0.0), std::pair(1, 0.0), std::pair(2, 1e-7));
    const ModelRun run("tank_test", "-j 1 -D NP=10000 -D IAIR=" + std::to_string(air) +
                                        (heat > 0.0 ? " -D HCONV=1E-7" : ""));
    REQUIRE(run.status() == 0);
    const double area = 6.0 * std::pow(VOLUME, 2.0 / 3.0);
    oracle::FillingTank tank;
    tank.volume = VOLUME;
    tank.contents = {{AIR, P_ATM * VOLUME / (GAS_CONSTANT * T_ATM)}, {PRODUCTS, 0.0}};
    tank.energy = tank.contents[0].moles * AIR.energy(T_ATM);

    const std::string bag = "/history/airbag/1/";
    const auto time = run.history("/history/time"), p = run.history(bag + "pressure"),
               T = run.history(bag + "temperature"), mass = run.history(bag + "mass_in");
    double now = 0.0, worst_T = 0.0, worst_p = 0.0, inflow = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] > now)
            tank.fill(
                now, time[i], 20, [](double t) { return MASS_FLOW(t) / MOLAR_MASS; }, TEMPERATURE,
                [heat = heat, area](double at) { return heat * area * (at - T_ATM); });
        now = time[i];
        worst_T = std::max(worst_T, std::abs(T[i] / tank.temperature() - 1.0));
        // a sample is of 10 000 particles that fly: 1.0 % of scatter in 2/3 of their energy
        worst_p = std::max(worst_p, std::abs(p[i] / tank.pressure() - 1.0));
        inflow = tank.contents[1].moles * MOLAR_MASS;
    }
    WARN("air " << air << ", HCONV " << heat << ": temperature is off by " << worst_T
                << ", pressure by " << worst_p << " at worst");
    CHECK(worst_T < 0.001);
    CHECK(worst_p < 0.03);
    CHECK(run.mean(bag + "part/1/pressure", 45.0, 100.0) ==
          Approx(heat > 0.0 ? run.mean(bag + "pressure", 45.0, 100.0) : tank.pressure())
              .epsilon(0.002));
    CHECK(mass.back() == Approx(inflow).epsilon(2e-4));
    const double brought = run.history("/history/energy/inflow").back();
    for (const double residual : run.history("/history/energy/residual"))
        REQUIRE(std::abs(residual) < 1e-9 * brought);
}
