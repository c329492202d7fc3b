// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Rooms of a bag that pass gas to each other, against the differential equations of two stirred
// tanks.

#include <algorithm>
#include <cmath>

#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/two_tanks.hpp"

namespace corpuscle::verify {
namespace {

using oracle::StirredTank;
using oracle::TwoTanks;

constexpr double ATM = 101325.0, WALL = 0.1 * 0.1;  ///< pressure; wall between the rooms    [m^2]
constexpr int STEPS_A_SAMPLE = 50;

std::string room_of(std::size_t r) {
    return "/history/airbag/1/chamber/" + std::to_string(r + 1) + "/";
}

/// Worst relative errors of mass and temperature of both rooms over all samples after `from`, of
/// rooms that are as `gases` say at that time.
std::map<std::string, double> worst_of_rooms(
    const MeasuredRun& run, double from, const std::array<std::vector<StirredTank::Gas>, 2>& gases,
    const std::array<TwoTanks::Rule, 2>& rules) {
    TwoTanks exact;
    for (std::size_t r = 0; r < 2; ++r) {
        exact.tanks[r] = {gases[r], run.at(room_of(r) + "energy", from),
                          run.at(room_of(r) + "volume", from)};
        for (StirredTank::Gas& gas : exact.tanks[r].gases)
            gas.mass *= run.at(room_of(r) + "mass", from);
    }
    std::map<std::string, double> worst;
    const auto time = run.time();
    std::array<std::vector<double>, 2> mass, temperature;
    for (std::size_t r = 0; r < 2; ++r) {
        mass[r] = run.read(room_of(r) + "mass");
        temperature[r] = run.read(room_of(r) + "temperature");
    }
    double now = from;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] <= from) continue;
        exact.advance(now, time[i], STEPS_A_SAMPLE, rules);
        now = time[i];
        for (std::size_t r = 0; r < 2; ++r) {
            const auto keep = [&](const char* what, double found, double wanted) {
                double& most = worst[what + std::to_string(r + 1)];
                most = std::max(most, std::abs(found / wanted - 1.0));
            };
            keep("mass_", mass[r][i], exact.tanks[r].mass());
            keep("temperature_", temperature[r][i], exact.tanks[r].temperature());
        }
    }
    return worst;
}

}  // namespace

/// Air in the first room, carbon dioxide in the second; from 3 ms on each gives density · area · FLC(t) ·
/// FAC(p) to the other, p and density of its own side.
Findings seeping_wall(const Runs& runs) {
    constexpr double OPENS_AT = 3e-3, RAMP = 1e-3, FLC = 0.05, FAC = 40.0, FAC_AT = 405300.0;
    const TwoTanks::Rule seeps = [](double t, const StirredTank& from, const StirredTank&) {
        const double open = FLC * std::clamp((t - OPENS_AT) / RAMP, 0.0, 1.0);
        const double velocity = FAC * std::min(1.0, from.pressure() / FAC_AT);
        return TwoTanks::Share{.across = WALL * open * velocity / from.volume};
    };
    return by_run(runs, [&](const MeasuredRun& run) {
        return worst_of_rooms(
            run, OPENS_AT,
            {{{{0.028, 28.0, 1.0}, {0.044, 37.0, 0.0}}, {{0.028, 28.0, 0.0}, {0.044, 37.0, 1.0}}}},
            {seeps, seeps});
    });
}

/// Initial air of 3 atm; the first room vents, the wall between the rooms has holes. Air without
/// particles goes to the lower pressure by Wang and Nefske's flow, particles effuse both ways.
Findings air_in_rooms(const Runs& runs) {
    constexpr double VENT = 0.2 * 0.01 / 9.0, HOLES = 0.02 * WALL, M = 0.028, CP = 28.0;
    constexpr double SAMPLE = 1e-4;
    const double pi = std::acos(-1.0);
    return by_run(runs, [&](const MeasuredRun& run) {
        const double switches = run.parameter("TSW");
        const bool is_switched = switches < run.time().back();
        const bool effuses = run.parameter("IAIR") == 2.0 && !is_switched;
        const auto nozzle = [](const StirredTank& from, double outside) {
            return oracle::nozzle_flux(from.pressure(), from.temperature(), M, CP, outside) /
                   from.mass();
        };
        const auto across = [&](double, const StirredTank& from, const StirredTank& to) {
            if (!effuses) return TwoTanks::Share{.across = HOLES * nozzle(from, to.pressure())};
            const double speed = std::sqrt(GAS_CONSTANT * from.temperature() / (2.0 * pi * M));
            return TwoTanks::Share{.across = HOLES * speed / from.volume, .less = 0.5};
        };
        const auto vents = [&](double t, const StirredTank& from, const StirredTank& to) {
            TwoTanks::Share share = across(t, from, to);
            share.out = VENT * nozzle(from, ATM);
            return share;
        };
        const std::vector<StirredTank::Gas> air{{M, CP, 1.0}};
        return worst_of_rooms(run, is_switched ? switches + SAMPLE : 0.0, {air, air},
                              {vents, across});
    });
}

}  // namespace corpuscle::verify
