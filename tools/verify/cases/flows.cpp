// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Waves in gas, against the Euler equations: Sod's tube, vacuum, the fast piston, a shock of a piston.

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/constants.hpp"
#include "tools/verify/case_list.hpp"
#include "tools/verify/exact/exact_riemann.hpp"
#include "tools/verify/exact/fast_piston.hpp"

namespace corpuscle::verify {
namespace {

constexpr std::size_t TUBE_SLABS = 100;

/// Density and pressure in slabs of a tube of 1 m, over those of the left side at the start.
struct Profile {
    std::array<double, TUBE_SLABS> density{}, pressure{};

    void add(const Profile& other, double weight) {
        for (std::size_t b = 0; b < TUBE_SLABS; ++b) {
            density[b] += weight * other.density[b];
            pressure[b] += weight * other.pressure[b];
        }
    }
};

constexpr double P_LEFT = 1e5, T_LEFT = 300.0, M_TUBE = 0.028, SECTION = 0.01;  ///< of the left

/// rho and p = (sum m v² - (sum m v_x)² / sum m) / 3 V in the last frame.
Profile measured(const MeasuredRun& run) {
    const std::string frame = run.frames().back() + "particles/";
    const auto x = run.vectors(frame + "position"), v = run.vectors(frame + "velocity");
    const auto mass = run.read(frame + "mass");
    std::array<double, TUBE_SLABS> m{}, mv{}, mvv{};
    for (std::size_t i = 0; i < mass.size(); ++i) {
        const auto slab = static_cast<std::size_t>(std::max(0.0, x[i].x() * TUBE_SLABS));
        const std::size_t b = std::min(TUBE_SLABS - 1, slab);
        m[b] += mass[i];
        mv[b] += mass[i] * v[i].x();
        mvv[b] += mass[i] * v[i].squaredNorm();
    }
    constexpr double VOLUME = SECTION / TUBE_SLABS;
    constexpr double DENSITY = P_LEFT * M_TUBE / (GAS_CONSTANT * T_LEFT);
    Profile profile;
    for (std::size_t b = 0; b < TUBE_SLABS; ++b) {
        profile.density[b] = m[b] / VOLUME / DENSITY;
        profile.pressure[b] = (mvv[b] - mv[b] * mv[b] / m[b]) / (3.0 * VOLUME) / P_LEFT;
    }
    return profile;
}

/// `t` after the opening, in the middles of the slabs.
Profile exact(double t) {
    const double c_T = std::sqrt(GAS_CONSTANT * T_LEFT / M_TUBE);
    Profile profile;
    for (std::size_t b = 0; b < TUBE_SLABS; ++b) {
        const double x = (static_cast<double>(b) + 0.5) / TUBE_SLABS - 0.5;
        const oracle::Gas1D gas =
            oracle::exact_riemann(1.4, {1.0, 0.0, 1.0}, {0.125, 0.0, 0.1}, x / (t * c_T));
        profile.density[b] = gas.density;
        profile.pressure[b] = gas.pressure;
    }
    return profile;
}

double distance(const std::array<double, TUBE_SLABS>& a, const std::array<double, TUBE_SLABS>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < TUBE_SLABS; ++i) sum += std::abs(a[i] - b[i]) / TUBE_SLABS;
    return sum;
}

/// L1 distance of the runs' mean from the exact solution; its interval by the jackknife.
template <class Values>
Estimate ensemble_error(const std::vector<Profile>& found, const std::vector<Profile>& truth,
                        Values&& values) {
    return jackknife(found.size(), [&](std::size_t left_out) {
        Profile mean, right;
        const double count =
            static_cast<double>(found.size()) - (left_out < found.size() ? 1.0 : 0.0);
        for (std::size_t k = 0; k < found.size(); ++k) {
            if (k == left_out) continue;
            mean.add(found[k], 1.0 / count);
            right.add(truth[k], 1.0 / count);
        }
        return distance(values(mean), values(right));
    });
}

/// Mean pressures in bins of 0.1 ms from the piston's start to 4 ms after, of samples that are
/// means since the sample before.
std::vector<double> binned(const std::vector<double>& time, const std::vector<double>& pressure) {
    Curve impulse;
    impulse.x = time;
    impulse.y.push_back(0.0);
    for (std::size_t i = 1; i < time.size(); ++i)
        impulse.y.push_back(impulse.y.back() + pressure[i] * (time[i] - time[i - 1]));
    constexpr double BIN = 1.0e-4;
    std::vector<double> mean;
    for (int bin = 0; bin < 40; ++bin) {
        const double from = oracle::fast_piston::START + bin * BIN;
        mean.push_back((impulse(from + BIN) - impulse(from)) / BIN);
    }
    return mean;
}

}  // namespace

/// The membrane at 0.5 m opens as a valve at 3 ms; the flow is looked at 0.2 m / c_T later.
Findings sod(const Runs& runs) {
    constexpr double OPENS = 3e-3;
    std::vector<Profile> found, truth;
    for (const MeasuredRun& run : runs) {
        const auto time = run.time();  // a row a step: the valve opens with the first from OPENS on
        const auto opened = std::lower_bound(time.begin(), time.end(), OPENS);
        found.push_back(measured(run));
        truth.push_back(exact(time.back() - *opened));
    }
    return {{"density", ensemble_error(found, truth, [](auto& of) { return of.density; })},
            {"pressure", ensemble_error(found, truth, [](auto& of) { return of.pressure; })}};
}

/// The same tube with nothing right of the membrane: the fan ends in vacuum.
///     c/c0 = 2/(gamma+1) - (gamma-1)/(gamma+1) x/(c0 t),   rho/rho0 = (c/c0)^(2/(gamma-1))
Findings vacuum(const Runs& runs) {
    constexpr double OPENS = 3e-3, GAMMA = 1.4;
    const double c0 = std::sqrt(GAMMA * GAS_CONSTANT * T_LEFT / M_TUBE);
    std::vector<Profile> found, truth;
    for (const MeasuredRun& run : runs) {
        const auto time = run.time();
        const double t = time.back() - *std::lower_bound(time.begin(), time.end(), OPENS);
        found.push_back(measured(run));
        Profile fan;
        for (std::size_t b = 0; b < TUBE_SLABS; ++b) {
            const double x = (static_cast<double>(b) + 0.5) / TUBE_SLABS - 0.5;
            const double c = (2.0 - (GAMMA - 1.0) * x / (c0 * t)) / (GAMMA + 1.0);
            fan.density[b] = std::pow(std::clamp(c, 0.0, 1.0), 2.0 / (GAMMA - 1.0));
        }
        truth.push_back(fan);
    }
    return {{"density", ensemble_error(found, truth, [](auto& of) { return of.density; })}};
}

/// models/fast_piston: the piston's pressure by Euler's equations on 400 cells.
Findings fast_piston(const Runs& runs) {
    namespace piston = oracle::fast_piston;
    constexpr double PLATEAU[] = {5.5e-3, 5.8e-3}, STOPPED[] = {6.1e-3, 6.4e-3};
    std::vector<double> fine;
    for (int i = 0; i <= 4000; ++i) fine.push_back(piston::START + i * 1.0e-6);
    const std::vector<double> euler = piston::piston_pressure(fine, 400);
    const auto exact = binned(fine, euler);
    const auto mean_of_euler = [&](const double(&span)[2]) {
        double sum = 0.0, count = 0.0;
        for (std::size_t i = 0; i < fine.size(); ++i)
            if (fine[i] > span[0] && fine[i] <= span[1]) {
                sum += euler[i];
                count += 1.0;
            }
        return sum / count;
    };
    const double plateau = mean_of_euler(PLATEAU), stopped = mean_of_euler(STOPPED);
    return by_run(runs, [&](const MeasuredRun& run) {
        const std::string pressure = "/history/airbag/1/part/2/pressure";
        const auto found = binned(run.time(), run.read(pressure));
        double sum = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i)
            sum += std::pow(found[i] - exact[i], 2) / static_cast<double>(exact.size());
        return std::map<std::string, double>{
            {"pressure", std::sqrt(sum) / piston::PRESSURE},
            {"plateau", (run.mean(pressure, PLATEAU[0], PLATEAU[1]) - plateau) / piston::PRESSURE},
            {"stopped", (run.mean(pressure, STOPPED[0], STOPPED[1]) - stopped) / piston::PRESSURE}};
    });
}

/// A piston runs into air at rest at 60 m/s: a shock at W ahead of it [Toro, 3.1.3],
///     W = (gamma+1)/4 u + sqrt(((gamma+1)/4 u)² + c²),   p - p0 = rho0 W u,
/// which comes back from the closed end.
Findings piston_wave(const Runs& runs) {
    constexpr double GAMMA = 28.0 / (28.0 - GAS_CONSTANT), P0 = 101325.0, U = 60.0;
    const double rho = P0 * M_TUBE / (GAS_CONSTANT * T_LEFT), c = std::sqrt(GAMMA * P0 / rho);
    const double g = 0.25 * (GAMMA + 1.0) * U, W = g + std::sqrt(g * g + c * c);
    const double rise = rho * W * U, arrives = 1.0 / W;
    // gas that runs at u against a wall: the state between equal streams
    const double rho_1 = rho * W / (W - U);
    const oracle::Gas1D left{rho_1, U, P0 + rise}, right{rho_1, -U, P0 + rise};
    const double echo = oracle::exact_riemann(GAMMA, left, right, 0.0).pressure - P0;
    return by_run(runs, [&](const MeasuredRun& run) {
        const std::string near = "/history/airbag/1/part/2/pressure",
                          far = "/history/airbag/1/part/3/pressure";
        // as much impulse as if the full rise had come at once, at the time of arrival
        const double until = 1.5 * arrives;
        const double impulse = (run.mean(far, 0.0, until) - P0) * until;
        const double begin = until - impulse / echo;
        return std::map<std::string, double>{
            {"speed", (1.0 / begin) / W - 1.0},
            {"impedance", (run.mean(near, 0.0, 1.7 * arrives) - P0) / rise - 1.0},
            {"echo", (run.mean(far, 1.2 * arrives, 1.7 * arrives) - P0) / echo - 1.0}};
    });
}

}  // namespace corpuscle::verify
