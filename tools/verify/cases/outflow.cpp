// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Tanks that empty through vents and cloth, against the differential equations of a stirred tank.

#include <algorithm>
#include <array>
#include <cmath>

#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/euler_duct.hpp"
#include "tools/verify/exact/graham.hpp"
#include "tools/verify/exact/stirred_tank.hpp"

namespace corpuscle::verify {
namespace {

const std::string TANK = "/history/airbag/1/";
constexpr double OPENS = 5e-3;  ///< of the tanks of models/                                 [s]
constexpr double P_ATM = 101325.0;

/// The gas of a run as it is when the tank opens.
oracle::StirredTank tank_at_opening(const MeasuredRun& run,
                                    std::vector<oracle::StirredTank::Gas> gases) {
    for (std::size_t g = 0; g < gases.size(); ++g)
        gases[g].mass = run.at(TANK + "species/" + std::to_string(g + 1) + "/mass", OPENS);
    return {std::move(gases), run.at(TANK + "energy", OPENS), run.at(TANK + "volume", OPENS)};
}

/// Greatest relative error of a history over all samples after `opens`.
template <class Share, class Value>
double worst_error(const MeasuredRun& run, oracle::StirredTank tank, const std::string& path,
                   Share&& share, Value&& value, double opens = OPENS) {
    const auto time = run.time(), measured = run.read(path);
    double worst = 0.0, now = opens;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] <= opens) continue;
        tank.empty(time[i] - now, 50, share);
        now = time[i];
        worst = std::max(worst, std::abs(measured[i] / value(tank) - 1.0));
    }
    return worst;
}

/// What leaves models/vented_tank by Wang and Nefske's flow, of what is there.               [1/s]
auto vented_share(const MeasuredRun& run, double M, double cp) {
    constexpr double AREA = 0.1 * 0.1 / 9.0;
    return [C23 = run.parameter("C23"), M, cp](const oracle::StirredTank& now) {
        return C23 * AREA / now.mass() *
               oracle::nozzle_flux(now.pressure(), now.temperature(), M, cp, P_ATM);
    };
}

/// Gas that stays in a tank expands without heat, at any rate of outflow: T m^(1 - gamma) is kept.
double worst_off_isentrope(const MeasuredRun& run, double gamma) {
    const auto time = run.time(), T = run.read(TANK + "temperature"), m = run.read(TANK + "mass");
    const double T_0 = run.at(TANK + "temperature", OPENS), m_0 = run.at(TANK + "mass", OPENS);
    double worst = 0.0;
    for (std::size_t i = 0; i < time.size(); ++i) {
        if (time[i] <= OPENS) continue;
        worst = std::max(worst, std::abs(T[i] / T_0 / std::pow(m[i] / m_0, gamma - 1.0) - 1.0));
    }
    return worst;
}

}  // namespace

/// models/vented_tank: Wang and Nefske's flow through 11.1 cm², from 5 atm down.
Findings vented_tank(const Runs& runs) {
    constexpr double M = 0.028, CP = 28.0;
    return by_run(runs, [&](const MeasuredRun& run) {
        const auto share = vented_share(run, M, CP);
        const oracle::StirredTank tank = tank_at_opening(run, {{M, CP, 0.0}});
        const auto mass = [](const oracle::StirredTank& now) { return now.mass(); };
        const auto heat = [](const oracle::StirredTank& now) { return now.temperature(); };
        return std::map<std::string, double>{
            {"mass", worst_error(run, tank, TANK + "mass", share, mass)},
            {"temperature", worst_error(run, tank, TANK + "temperature", share, heat)},
            {"isentrope", worst_off_isentrope(run, CP / (CP - GAS_CONSTANT))}};
    });
}

/// The same tank in flight: its gas holds m v²/2 more, and that alone.
Findings flying_box(const Runs& runs) {
    constexpr double M = 0.028, CP = 28.0;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double vx = run.parameter("VX"), vy = run.parameter("VY");
        oracle::StirredTank tank = tank_at_opening(run, {{M, CP, 0.0}});
        tank.energy -= 0.5 * tank.mass() * (vx * vx + vy * vy);
        const auto share = vented_share(run, M, CP);
        const auto mass = [](const oracle::StirredTank& now) { return now.mass(); };
        const auto heat = [](const oracle::StirredTank& now) { return now.temperature(); };
        return std::map<std::string, double>{
            {"mass", worst_error(run, tank, TANK + "mass", share, mass)},
            {"temperature", worst_error(run, tank, TANK + "static_temperature", share, heat)}};
    });
}

/// models/vented_tank with a small plain vent: gas at rest effuses, with 1/2 R T / M more than u.
Findings effusion(const Runs& runs) {
    constexpr double AREA = 0.1 * 0.1 / 9.0, M = 0.028, CP = 28.0, STEPS = 20.0;
    const double pi = std::acos(-1.0), cv = (CP - GAS_CONSTANT) / M, R = GAS_CONSTANT / M;
    return by_run(runs, [&](const MeasuredRun& run) {
        const double C23 = run.parameter("C23"), volume = run.at(TANK + "volume", OPENS);
        const auto time = run.time(), mass = run.read(TANK + "mass"),
                   temperature = run.read(TANK + "temperature");
        double m = run.at(TANK + "mass", OPENS), T = run.at(TANK + "temperature", OPENS);
        double now = OPENS, worst_m = 0.0, worst_T = 0.0;
        for (std::size_t i = 0; i < time.size(); ++i) {
            if (time[i] <= OPENS) continue;
            const double dt = (time[i] - now) / STEPS;
            for (int k = 0; k < STEPS; ++k) {
                // cv m dT = -(R T / 2) dm, by the midpoint rule
                const auto rate = [&](double at_T) {
                    return C23 * AREA / volume * std::sqrt(R * at_T / (2.0 * pi));
                };
                const double T_middle = T - 0.25 * dt * rate(T) * R / cv * T;
                const double out = rate(T_middle) * dt;
                m *= std::exp(-out);
                T *= std::exp(-0.5 * R / cv * out);
            }
            now = time[i];
            worst_m = std::max(worst_m, std::abs(mass[i] / m - 1.0));
            worst_T = std::max(worst_T, std::abs(temperature[i] / T - 1.0));
        }
        return std::map<std::string, double>{{"mass", worst_m}, {"temperature", worst_T}};
    });
}

/// models/porous_tank: both gases leave in proportion to their densities.
Findings porous_tank(const Runs& runs) {
    const auto share = [](const oracle::StirredTank& now) {
        const double velocity =
            60.0 * std::clamp((now.pressure() - P_ATM) / (4.0 * P_ATM), 0.0, 1.0);
        return 6.0 * 0.1 * 0.1 * 0.1 * velocity / now.volume;
    };
    return by_run(runs, [&](const MeasuredRun& run) {
        const oracle::StirredTank tank =
            tank_at_opening(run, {{0.028, 28.0, 0.0}, {0.004, 20.79, 0.0}});
        const auto error = [&](std::size_t gas) {
            const auto mass = [gas](const oracle::StirredTank& now) { return now.gases[gas].mass; };
            return worst_error(run, tank, TANK + "species/" + std::to_string(gas + 1) + "/mass",
                               share, mass);
        };
        return std::map<std::string, double>{{"air", error(0)}, {"helium", error(1)}};
    });
}

/// Halves of half a litre, air in the first and helium in the second until 3 ms, then 1 cm² of holes.
Findings mixing_chambers(const Runs& runs) {
    constexpr double HALF = 0.5e-3, T = 300.0, MIDDLE = 0.05, HOLES = 1e-4, FROM = 3e-3;
    constexpr double N = P_ATM * HALF / (GAS_CONSTANT * T), AIR = 28.0, HELIUM = 20.786;
    return by_run(runs, [&](const MeasuredRun& run) {
        oracle::GrahamRooms exact{{{{0.028, AIR}, {0.004, HELIUM}}},
                                  {{{{N, 0.0}, N * (AIR - GAS_CONSTANT) * T},
                                    {{0.0, N}, N * (HELIUM - GAS_CONSTANT) * T}}},
                                  HALF,
                                  HOLES};
        const auto time = run.read("/frames/time");
        const auto frames = run.frames();
        double now = FROM, air = 0.0, helium = 0.0, pressure = 0.0, count = 0.0;
        for (std::size_t f = 0; f < frames.size(); ++f) {
            if (time[f] < FROM + 1e-3) continue;
            exact.advance(time[f] - now, 200);
            now = time[f];
            const std::string of = frames[f] + "particles/";
            const auto x = run.vectors(of + "position"), v = run.vectors(of + "velocity");
            const auto mass = run.read(of + "mass"), gas = run.read(of + "species");
            std::array<double, 2> all{}, crossed{}, motion{};  // by gas, by gas, by half
            for (std::size_t i = 0; i < mass.size(); ++i) {
                const std::size_t g = gas[i] == 1.0 ? 0 : 1, half = x[i].x() < MIDDLE ? 0 : 1;
                all[g] += mass[i];
                if (g != half) crossed[g] += mass[i];
                motion[half] += mass[i] * v[i].squaredNorm();
            }
            const auto& rooms = exact.rooms;
            air += crossed[0] / all[0] - rooms[1].moles[0] / N;
            helium += crossed[1] / all[1] - rooms[0].moles[1] / N;
            pressure += motion[0] / motion[1] - exact.pressure(rooms[0]) / exact.pressure(rooms[1]);
            count += 1.0;
        }
        return std::map<std::string, double>{
            {"air", air / count}, {"helium", helium / count}, {"pressure", pressure / count}};
    });
}

/// A control volume of a litre of air into which up to 1.5 kg/s flow, a vent of 1 cm² beside.
Findings uniform_tank(const Runs& runs) {
    constexpr double M = 0.028, CP = 28.0, VOLUME = 1e-3, AREA = 1e-4, C23 = 0.7;
    constexpr double T = 300.0, T_IN = 600.0, MOST = 1.5, RAMP = 2e-3;
    constexpr int STEPS = 100;  // a sample
    const auto inflow = [](double t) {
        return MOST * std::max(0.0, 1.0 - std::abs(t / RAMP - 1.0));
    };
    return by_run(runs, [&](const MeasuredRun& run) {
        const double first = P_ATM * VOLUME * M / (GAS_CONSTANT * T);
        oracle::StirredTank tank{{{M, CP, first}}, first / M * (CP - GAS_CONSTANT) * T, VOLUME};
        const auto moved = [&](const oracle::StirredTank& rates, double t, double span) {
            oracle::StirredTank to = tank;
            const double T_out = rates.temperature(), in = inflow(t);
            const double out =
                C23 * AREA * oracle::nozzle_flux(rates.pressure(), T_out, M, CP, P_ATM);
            to.gases[0].mass += span * (in - out);
            to.energy += span * CP / M * (in * T_IN - out * T_out);
            return to;
        };
        const auto time = run.time(), m = run.read(TANK + "mass"),
                   hot = run.read(TANK + "temperature");
        double mass = 0.0, heat = 0.0;
        for (std::size_t i = 1; i < time.size(); ++i) {
            const double dt = (time[i] - time[i - 1]) / STEPS;
            for (int k = 0; k < STEPS; ++k) {  // midpoint rule
                const double t = time[i - 1] + k * dt;
                tank = moved(moved(tank, t, 0.5 * dt), t + 0.5 * dt, dt);
            }
            mass = std::max(mass, std::abs(m[i] / tank.mass() - 1.0));
            heat = std::max(heat, std::abs(hot[i] / tank.temperature() - 1.0));
        }
        return std::map<std::string, double>{{"mass", mass}, {"temperature", heat}};
    });
}

/// Two chambers of half a litre at 5 atm; the first vents from 0.5 ms on.
Findings vent_by_chamber(const Runs& runs) {
    constexpr double C23 = 0.6, AREA = 0.01 / 9.0, M = 0.028, CP = 28.0, FROM = 0.5e-3;
    return by_run(runs, [&](const MeasuredRun& run) {
        const std::string vents = TANK + "chamber/1/", neighbour = TANK + "chamber/2/";
        oracle::StirredTank tank{{{M, CP, run.at(vents + "mass", 0.0)}},
                                 run.at(vents + "energy", 0.0),
                                 run.at(vents + "volume", 0.0)};
        const auto share = [&](const oracle::StirredTank& now) {
            return C23 * AREA / now.mass() *
                   oracle::nozzle_flux(now.pressure(), now.temperature(), M, CP, P_ATM);
        };
        const auto mass = [](const oracle::StirredTank& now) { return now.mass(); };
        return std::map<std::string, double>{
            {"mass", worst_error(run, tank, vents + "mass", share, mass, FROM)},
            {"neighbour", greatest_change(run, neighbour + "energy", 0.0, INF)}};
    });
}

/// Air at rest in a duct of 1 m, 5 kg/s from one end until 1 ms, a vent over the other end.
Findings far_vent(const Runs& runs) {
    constexpr double AREA = 0.01, RATE = 5.0, UNTIL = 1e-3, T = 300.0, M = 0.028, CP = 28.0;
    constexpr double GAMMA = CP / (CP - GAS_CONSTANT), SOURCE = 0.02;
    const double pi = std::acos(-1.0);
    // a jet has sqrt(3 R T / M), T of the gas at rest, spread evenly over a cone of 30 degrees
    const double jet = std::sqrt(3.0 * GAS_CONSTANT * T / M) * 0.5 * (1.0 + std::cos(pi / 6.0));
    const double flux = RATE / AREA, u = (CP - GAS_CONSTANT) / M * T;
    const oracle::DuctInflow on{flux, flux * jet, flux * u};
    return by_run(runs, [&](const MeasuredRun& run) {
        const oracle::Gas1D rest{P_ATM * M / (GAS_CONSTANT * T), 0.0, P_ATM};
        oracle::EulerDuct duct(GAMMA, 1.0, 400, rest, P_ATM, SOURCE);
        const auto time = run.time(), out = run.read(TANK + "mass_out_vent");
        double worst = 0.0, arrives = INF;
        for (std::size_t i = 0; i < time.size(); ++i) {
            duct.advance(std::min(time[i], UNTIL), on);
            duct.advance(time[i], {0.0, 0.0, 0.0});
            worst = std::max(worst, std::abs(out[i] - duct.mass_out() * AREA));
            if (std::isinf(arrives) && duct.mass_out() * AREA > 1e-3 * RATE * UNTIL)
                arrives = time[i];
        }
        return std::map<std::string, double>{
            {"early", run.at(TANK + "mass_out_vent", 0.9 * arrives) / (RATE * UNTIL)},
            {"mass", worst / (duct.mass_out() * AREA)}};
    });
}

}  // namespace corpuscle::verify
