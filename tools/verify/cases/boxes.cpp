// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas in closed boxes: p = n R T / V, Maxwell's distribution of speeds, p V^gamma.

#include <cmath>

#include "solver/base/constants.hpp"
#include "tools/verify/case_list.hpp"

namespace corpuscle::verify {
namespace {

const std::string BAG = "/history/airbag/1/";

/// Speeds of one gas in the last frames of all runs.                                     [m/s]
std::vector<double> speeds(const Runs& runs, double species) {
    std::vector<double> found;
    for (const MeasuredRun& run : runs) {
        const std::string frame = run.frames().back() + "particles/";
        const auto of = run.read(frame + "species");
        const auto v = run.vectors(frame + "velocity");
        for (std::size_t i = 0; i < v.size(); ++i)
            if (of[i] == species) found.push_back(v[i].norm());
    }
    return found;
}

/// Kolmogorov and Smirnov's distance from Maxwell's speeds at T, of the seeds taken together.
Estimate maxwell(const Runs& runs, double species, double T, double molar_mass) {
    const double a = std::sqrt(GAS_CONSTANT * T / molar_mass);
    return {kolmogorov_smirnov(speeds(runs, species),
                               [a](double speed) { return maxwell_below(speed, a); }),
            NaN};
}

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
    found["maxwell"] = maxwell(runs, 0.0, T, MOLAR_MASS);
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
    found["maxwell_air"] = maxwell(runs, 1.0, T, gases[0].M);
    found["maxwell_helium"] = maxwell(runs, 2.0, T, gases[1].M);
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

}  // namespace corpuscle::verify
