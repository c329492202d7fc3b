// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas in closed boxes: p = n R T / V, Maxwell's distribution of speeds, p V^gamma, inflow and heat.

#include <algorithm>
#include <cmath>

#include "solver/base/constants.hpp"
#include "solver/base/curve.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/filling_tank.hpp"

namespace corpuscle::verify {
namespace {

const std::string BAG = "/history/airbag/1/";

}  // namespace

/// 0.1 m, air at 1 atm and 300 K as particles from the start.
Findings box_at_rest(const Runs& runs) {
    constexpr double P = 101325.0, T = 300.0, MOLAR_MASS = 0.028;
    Findings found = by_run(runs, [&](const MeasuredRun& run) {
        const auto energy = run.read(BAG + "energy");
        return std::map<std::string, double>{
            {"pressure", run.mean(BAG + "part/1/pressure", 0.0, INF) / P - 1.0},
            {"temperature", run.last(BAG + "temperature") / T - 1.0},
            {"energy", energy.back() / energy.front() - 1.0}};
    });
    found["maxwell"] = maxwell_distance(runs, 0, T, MOLAR_MASS);
    return found;
}

/// models/helium_air: both gases come in with h(T_static), and end in one temperature.
Findings helium_air(const Runs& runs) {
    struct {
        double M, cp, T_static;
    } const gases[] = {{0.028, 28.0, 210.9}, {0.003, 20.79, 180.0}};
    constexpr double MASS = 0.1e-3, VOLUME = 1e-3, MIXED = 5e-3;
    double energy = 0.0, capacity = 0.0, moles = 0.0;
    for (const auto& gas : gases) {
        const double n = MASS / gas.M;
        moles += n;
        energy += n * gas.cp * gas.T_static;
        capacity += n * (gas.cp - GAS_CONSTANT);
    }
    const double T = energy / capacity, p = moles * GAS_CONSTANT * T / VOLUME;
    Findings found = by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{
            {"pressure", run.mean(BAG + "part/1/pressure", MIXED, INF) / p - 1.0},
            {"air", run.mean(BAG + "species/1/temperature", MIXED, INF) / T - 1.0},
            {"helium", run.mean(BAG + "species/2/temperature", MIXED, INF) / T - 1.0}};
    });
    found["maxwell_air"] = maxwell_distance(runs, 1, T, gases[0].M);
    found["maxwell_helium"] = maxwell_distance(runs, 2, T, gases[1].M);
    return found;
}

/// Air whose box grows or shrinks by a slow piston, then stands for 10 ms. With Cp = A + B T
///     (A - R) ln T + B T + R ln V   is kept.
Findings slow_piston(const Runs& runs) {
    constexpr double P = 101325.0, T = 300.0, RESTS = 22e-3, A = 28.0;
    const double R = GAS_CONSTANT;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double B = run.parameter("B");
        const auto volume = run.read(BAG + "volume");
        const double ratio = volume.back() / volume.front();
        const auto entropy = [&](double at) { return (A - R) * std::log(at) + B * at; };
        double then = T;
        for (int k = 0; k < 50; ++k)
            then -= (entropy(then) - entropy(T) + R * std::log(ratio)) / ((A - R) / then + B);
        const double p = P * then / T / ratio;
        return std::map<std::string, double>{
            {"pressure", run.mean(BAG + "part/2/pressure", RESTS, INF) / p - 1.0},
            {"temperature", run.mean(BAG + "temperature", RESTS, INF) / then - 1.0}};
    });
}

/// models/two_chambers: the gases are in until 1 ms.
Findings closed_membrane(const Runs& runs) {
    return by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{
            {"warm", greatest_change(run, BAG + "species/1/energy", 2e-3, INF)},
            {"cold", greatest_change(run, BAG + "species/2/energy", 2e-3, INF)}};
    });
}

/// models/two_inflators: rooms of a litre with 0.1 g each, apart until 1.89 ms, then mixed.
Findings two_inflators(const Runs& runs) {
    constexpr double M = 0.028, T = 165.0, VOLUME = 2e-3, MASS = 2e-4, MIXED = 0.05;
    const double p = MASS / M * GAS_CONSTANT * T / VOLUME;
    const std::string hot = BAG + "species/1/", cold = BAG + "species/2/";
    Findings found = by_run(runs, [&](const MeasuredRun& run) {
        return std::map<std::string, double>{
            {"apart", std::max(greatest_change(run, hot + "energy", 0.4e-3, 1.89e-3),
                               greatest_change(run, cold + "energy", 0.4e-3, 1.89e-3))},
            {"hot", run.mean(hot + "temperature", MIXED, INF) / T - 1.0},
            {"cold", run.mean(cold + "temperature", MIXED, INF) / T - 1.0},
            {"pressure", run.mean(BAG + "part/1/pressure", MIXED, INF) / p - 1.0}};
    });
    found["maxwell_hot"] = maxwell_distance(runs, 1, T, M);
    found["maxwell_cold"] = maxwell_distance(runs, 2, T, M);
    return found;
}

/// models/tank_test: an inflator's curves into 60 litres of air, in kg, mm, ms, K.
Findings tank_test(const Runs& runs) {
    constexpr double VOLUME = 60.0e6, T_ATM = 293.0, P_ATM = 1.01325e-4, M = 0.0285;
    constexpr double DONE = 45.0;  // all gas is in                                        [ms]
    const oracle::IdealGas air{29.1, 0.0}, products{27.0, 0.0056};
    Curve flow, heat;
    flow.x = {0, 1, 7, 12, 20, 30, 40, 40};
    flow.y = {0, 0.5e-3, 1.6e-3, 1.5e-3, 0.9e-3, 0.45e-3, 0.1e-3, 0};
    heat.x = {0, 1, 7, 12, 20, 30, 40};
    heat.y = {700, 750, 800, 800, 720, 640, 600};
    return by_run(runs, [&](const MeasuredRun& run) {
        const double area = 6.0 * std::pow(VOLUME, 2.0 / 3.0), h = run.parameter("HCONV");
        oracle::FillingTank tank;
        tank.volume = VOLUME;
        tank.contents = {{air, P_ATM * VOLUME / (GAS_CONSTANT * T_ATM)}, {products, 0.0}};
        tank.energy = tank.contents[0].moles * air.energy(T_ATM);
        const auto time = run.time(), T = run.read(BAG + "temperature");
        double now = 0.0, worst = 0.0, p = 0.0, count = 0.0;
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (time[i] > now)
                tank.fill(
                    now, time[i], 20, [&](double t) { return flow(t) / M; }, heat,
                    [&](double at) { return h * area * (at - T_ATM); });
            now = time[i];
            worst = std::max(worst, std::abs(T[i] / tank.temperature() - 1.0));
            if (now <= DONE) continue;
            p += tank.pressure();
            count += 1.0;
        }
        return std::map<std::string, double>{
            {"temperature", worst},
            {"pressure", run.mean(BAG + "part/1/pressure", DONE, INF) / (p / count) - 1.0},
            {"mass", run.last(BAG + "mass_in") / (tank.contents[1].moles * M) - 1.0}};
    });
}

/// Air of 600 K in a litre whose walls of 300 K take h A (T - 300 K):
///     T = 300 K + 300 K exp(-h A t / (n cv))
Findings cooling(const Runs& runs) {
    constexpr double P = 202650.0, T = 600.0, T_WALL = 300.0, CP = 28.0;
    constexpr double VOLUME = 1e-3, AREA = 0.06;
    const double capacity = P * VOLUME / (GAS_CONSTANT * T) * (CP - GAS_CONSTANT);
    return by_run(runs, [&](const MeasuredRun& run) {
        const double rate = run.parameter("HCONV") * AREA / capacity;
        const auto time = run.time(), found = run.read(BAG + "temperature");
        double worst = 0.0;
        for (std::size_t i = 0; i < time.size(); ++i) {
            const double exact = T_WALL + (T - T_WALL) * std::exp(-rate * time[i]);
            worst = std::max(worst, std::abs(found[i] / exact - 1.0));
        }
        const double lost = capacity * (T - T_WALL) * (1.0 - std::exp(-rate * time.back()));
        return std::map<std::string, double>{
            {"temperature", worst}, {"heat", run.last(BAG + "part/1/heat_lost") / lost - 1.0}};
    });
}

}  // namespace corpuscle::verify
