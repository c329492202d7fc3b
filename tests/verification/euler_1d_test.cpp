// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
// The 1-D Euler oracle against what is known exactly: it judges the gas, so it is judged first.
#include <catch2/catch.hpp>
#include <cmath>

#include "tools/verify/exact/euler_1d.hpp"
#include "tools/verify/exact/exact_riemann.hpp"
#include "tools/verify/exact/fast_piston.hpp"

using namespace corpuscle;
using oracle::EulerTube;
using oracle::Gas1D;

namespace {

constexpr Gas1D SOD_LEFT{1.0, 0.0, 1.0}, SOD_RIGHT{0.125, 0.0, 0.1};

double at_rest(double) {
    return 0.0;
}

struct SodError {
    double density, pressure;
};

/// L1 errors of Sod's tube of length 1 at t = 0.2.
SodError sod_error(std::size_t cells) {
    EulerTube tube(1.4, 1.0, cells, [](double x) { return x < 0.5 ? SOD_LEFT : SOD_RIGHT; });
    tube.advance(0.2, at_rest);
    SodError error{0.0, 0.0};
    const auto gas = tube.gas();
    for (std::size_t i = 0; i < cells; ++i) {
        const Gas1D exact =
            oracle::exact_riemann(1.4, SOD_LEFT, SOD_RIGHT, (tube.centre(i) - 0.5) / 0.2);
        error.density += std::abs(gas[i].density - exact.density) / static_cast<double>(cells);
        error.pressure += std::abs(gas[i].pressure - exact.pressure) / static_cast<double>(cells);
    }
    return error;
}

/// Pressure on a receding piston in a simple wave, gas 1 at rest with rho = 1, p = 1.
double simple_wave(double gamma, double u) {
    const double c = std::sqrt(gamma);
    return std::pow(1.0 - 0.5 * (gamma - 1.0) * u / c, 2.0 * gamma / (gamma - 1.0));
}

/// A piston that starts and stops smoothly: twice differentiable, 0.3 c at its fastest.
double smooth_piston(double t) {
    const double s = std::sin(4.0 * std::acos(-1.0) * std::min(t, 0.25));
    return 0.35 * s * s * s * s;
}

/// Mean error of the piston's pressure over the motion, before a wave comes back.
double simple_wave_error(std::size_t cells) {
    EulerTube tube(1.4, 1.0, cells, [](double) { return Gas1D{1.0, 0.0, 1.0}; });
    double error = 0.0;
    constexpr int SAMPLES = 50;
    for (int i = 1; i <= SAMPLES; ++i) {
        const double t = 0.25 * i / SAMPLES;
        tube.advance(t, smooth_piston);
        error += std::abs(tube.piston_pressure() - simple_wave(1.4, smooth_piston(t))) / SAMPLES;
    }
    return error;
}

}  // namespace

TEST_CASE("the exact Riemann solver gives Sod's star state", "[oracle]") {
    // Toro, table 4.3, test 1
    const Gas1D left_star = oracle::exact_riemann(1.4, SOD_LEFT, SOD_RIGHT, 0.9);
    const Gas1D right_star = oracle::exact_riemann(1.4, SOD_LEFT, SOD_RIGHT, 0.95);
    CHECK(left_star.pressure == Approx(0.30313).epsilon(2e-5));
    CHECK(left_star.velocity == Approx(0.92745).epsilon(2e-5));
    CHECK(left_star.density == Approx(0.42632).epsilon(2e-5));
    CHECK(right_star.density == Approx(0.26557).epsilon(2e-5));
    CHECK(oracle::exact_riemann(1.4, SOD_LEFT, SOD_RIGHT, -1.2).pressure == 1.0);
    CHECK(oracle::exact_riemann(1.4, SOD_LEFT, SOD_RIGHT, 1.76).pressure == 0.1);
}

TEST_CASE("Sod's tube converges to the exact solution", "[oracle]") {
    const SodError coarse = sod_error(100), fine = sod_error(400);
    const double order_p = std::log(coarse.pressure / fine.pressure) / std::log(4.0);
    const double order_rho = std::log(coarse.density / fine.density) / std::log(4.0);
    WARN("L1 density, pressure: 100 cells "
         << coarse.density << ", " << coarse.pressure << "; 400 cells " << fine.density << ", "
         << fine.pressure << "; orders " << order_rho << ", " << order_p);
    // a captured shock is first order in L1; a contact, smeared as it travels, is about 2/3
    CHECK(order_p > 0.85);
    CHECK(order_rho > 0.7);
    CHECK(fine.pressure < 0.0015);
    CHECK(fine.density < 0.002);
}

TEST_CASE("a smooth rarefaction off the piston is second order", "[oracle]") {
    const double coarse = simple_wave_error(100), middle = simple_wave_error(200),
                 fine = simple_wave_error(400);
    const double first = std::log2(coarse / middle), second = std::log2(middle / fine);
    WARN("mean error of the piston's pressure: " << coarse << ", " << middle << ", " << fine
                                                 << " on 100, 200, 400 cells; orders " << first
                                                 << ", " << second);
    CHECK(second > 1.8);
    CHECK(fine < 1e-4);
}

TEST_CASE("the tube keeps its mass, and its energy but for the piston's work", "[oracle]") {
    EulerTube tube(1.4, 1.0, 400, [](double) { return Gas1D{1.0, 0.0, 1.0}; });
    const double mass = tube.mass(), energy = tube.energy();
    double work = 0.0;
    constexpr int STEPS = 2500;
    for (int i = 0; i < STEPS; ++i) {
        const double t_0 = 0.25 * i / STEPS, t_1 = 0.25 * (i + 1) / STEPS;
        const double power_0 = tube.piston_pressure() * smooth_piston(t_0);
        tube.advance(t_1, smooth_piston);
        work += 0.5 * (t_1 - t_0) * (power_0 + tube.piston_pressure() * smooth_piston(t_1));
    }
    CHECK(tube.mass() == Approx(mass).epsilon(1e-13));
    CHECK(tube.energy() == Approx(energy - work).epsilon(1e-6));
}

TEST_CASE("a slow piston follows p V^gamma", "[oracle]") {
    EulerTube tube(1.4, 1.0, 50, [](double) { return Gas1D{1.0, 0.0, 1.0}; });
    // one length in 200 lengths of sound, starting and stopping gently
    const auto slow = [](double t) {
        const double s = std::sin(std::acos(-1.0) * t / 200.0);
        return 0.01 * s * s;
    };
    tube.advance(200.0, slow);
    CHECK(tube.length() == Approx(2.0).epsilon(1e-4));
    CHECK(tube.piston_pressure() * std::pow(tube.length(), 1.4) == Approx(1.0).epsilon(1e-3));
}

TEST_CASE("the notes' fast piston: 17.95 kPa while it runs, about 110 kPa just after it stops",
          "[oracle]") {
    using namespace oracle::fast_piston;
    const std::vector<double> times{5.3e-3, 5.5e-3, 5.7e-3, 6.0e-3, 6.02e-3};
    const auto pressure = piston_pressure(times, 800);
    const double c = std::sqrt(GAMMA * GAS_CONSTANT * TEMPERATURE / MOLAR_MASS);
    const double plateau =
        PRESSURE * std::pow(1.0 - 0.5 * (GAMMA - 1.0) * 400.0 / c, 2.0 * GAMMA / (GAMMA - 1.0));
    WARN("p0 " << PRESSURE << ", plateau " << plateau << ", on the piston at 5.3, 5.5, 5.7, 6.0, "
               << "6.02 ms: " << pressure[0] << ", " << pressure[1] << ", " << pressure[2] << ", "
               << pressure[3] << ", " << pressure[4]);
    CHECK(plateau == Approx(17950.0).epsilon(1e-3));
    for (int i = 0; i < 3; ++i) CHECK(pressure[i] == Approx(plateau).epsilon(2e-3));
    CHECK(pressure[3] == Approx(110e3).epsilon(0.02));
}

TEST_CASE("a tube whose walls leak alike empties as a tank does", "[oracle]") {
    constexpr double GAMMA = 1.4, SHARE = 3.0, T = 0.2;
    EulerTube tube(GAMMA, 1.0, 200, [](double) { return Gas1D{1.0, 0.0, 1.0}; });
    const double energy = tube.energy();
    tube.leak([](double, const Gas1D&) { return SHARE; });
    tube.advance(T, at_rest);
    // dm = -share m, dE = -share gamma E
    CHECK(tube.mass() == Approx(std::exp(-SHARE * T)).epsilon(1e-5));
    CHECK(tube.energy() == Approx(energy * std::exp(-SHARE * GAMMA * T)).epsilon(1e-5));
}
