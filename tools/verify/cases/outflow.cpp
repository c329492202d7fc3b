// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Tanks that empty through vents and cloth, against the differential equations of a stirred tank.

#include <cmath>

#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/stirred_tank.hpp"

namespace corpuscle::verify {
namespace {

const std::string BAG = "/history/airbag/1/";
constexpr double OPENS = 5e-3;  ///< of the tanks of models/                                 [s]
constexpr double P_ATM = 101325.0;

/// The gas of a run as it is when the tank opens.
oracle::StirredTank tank_at_opening(const MeasuredRun& run,
                                    std::vector<oracle::StirredTank::Gas> gases) {
    for (std::size_t g = 0; g < gases.size(); ++g)
        gases[g].mass = run.at(BAG + "species/" + std::to_string(g + 1) + "/mass", OPENS);
    return {std::move(gases), run.at(BAG + "energy", OPENS), run.at(BAG + "volume", OPENS)};
}

/// Greatest relative error of a history over all samples after the tank has opened.
template <class Share, class Value>
double worst_error(const MeasuredRun& run, oracle::StirredTank tank, const std::string& path,
                   Share&& share, Value&& value) {
    const auto time = run.time(), measured = run.read(path);
    double worst = 0.0, now = OPENS;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] <= OPENS) continue;
        tank.empty(time[i] - now, 50, share);
        now = time[i];
        worst = std::max(worst, std::abs(measured[i] / value(tank) - 1.0));
    }
    return worst;
}

}  // namespace

/// models/vented_tank: Wang and Nefske's flow through 11.1 cm², from 5 atm down.
Findings vented_tank(const Runs& runs) {
    constexpr double AREA = 0.1 * 0.1 / 9.0, M = 0.028, CP = 28.0;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double C23 = run.parameter("C23");
        const auto share = [&](const oracle::StirredTank& now) {
            return C23 * AREA / now.mass() *
                   oracle::nozzle_flux(now.pressure(), now.temperature(), M, CP, P_ATM);
        };
        const oracle::StirredTank tank = tank_at_opening(run, {{M, CP, 0.0}});
        const auto mass = [](const oracle::StirredTank& now) { return now.mass(); };
        const auto heat = [](const oracle::StirredTank& now) { return now.temperature(); };
        return std::map<std::string, double>{
            {"mass", worst_error(run, tank, BAG + "mass", share, mass)},
            {"temperature", worst_error(run, tank, BAG + "temperature", share, heat)}};
    });
}

}  // namespace corpuscle::verify
