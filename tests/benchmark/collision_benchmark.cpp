// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Run time against error of all collision models, one thread: Sod's tube and the notes' fast
// piston. Prints one table; `benchmark_collisions FILE.csv` writes it too
// (tools/figures/collisions.py).

#include <fmt/format.h>
#include <fmt/os.h>

#include <cmath>
#include <ctime>
#include <string>
#include <vector>

#include "gas/collision_name.hpp"
#include "solver/base/parallel.hpp"
#include "tests/support/fast_piston.hpp"
#include "tests/support/piston_box.hpp"
#include "tests/support/sod.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

/// How a model does best: cells of Sod's tube at 10^5 particles (smaller as n^(-1/3)), cfl.
struct Setting {
    CollisionModel model;
    double cells;
    double cfl;
};

constexpr Setting SETTINGS[] = {
    {CollisionModel::LIN, 60.0, 0.1},
    {CollisionModel::PAIRS, 100.0, 0.25},
    {CollisionModel::NTC, 100.0, 0.25},
    {CollisionModel::SPHERES, 60.0, 0.1},
};

/// Runs in the ensemble: as many as keep the whole below four minutes; fewer of the slow models.
int runs_of(CollisionModel model, std::size_t n) {
    if (n > 100000) return 2;
    const int most = n < 100000 ? 40 : 16;
    return model == CollisionModel::NTC       ? most / 2
           : model == CollisionModel::SPHERES ? most / 4
                                              : most;
}

/// Cells across the tube's 0.1, a whole number.
double edge_of(const Setting& setting, std::size_t n) {
    const double across = 0.1 * setting.cells * std::cbrt(static_cast<double>(n) / 1e5);
    return 0.1 / std::round(across);
}

/// Root-mean-square error of the pressure on the notes' fast piston, over that before it moves, in
/// bins of 0.1 ms from its start to 4 ms after; one run.
double piston_error(const Setting& setting, std::size_t n) {
    namespace piston = oracle::fast_piston;
    constexpr int BINS = 40;
    constexpr double BIN = 1e-4;
    const Mixture mixture = mixture_of({{piston::MOLAR_MASS, piston::CP, 0.0, 0.0}},
                                       piston::MASS / piston::MOLAR_MASS / static_cast<double>(n));
    const Vec3 size = Vec3::Constant(piston::SIDE);
    const double scale = setting.model == CollisionModel::LIN ? 20.0 : 10.0;
    PistonBox box(size, mixture, setting.model, random_gas(n, size, mixture, {piston::TEMPERATURE}),
                  cell_edge(size.prod(), n, scale));
    const double c_T = std::sqrt(GAS_CONSTANT * piston::TEMPERATURE / piston::MOLAR_MASS);
    const int steps = static_cast<int>(std::ceil(BIN / (setting.cfl * box.edge() / c_T)));
    const double dt = BIN / steps;

    oracle::EulerTube exact = piston::tube(400);
    double squares = 0.0, time = 0.0;
    for (int b = 0; b < BINS; ++b) {
        double wanted = 0.0;
        box.piston_impulse = 0.0;
        for (int i = 0; i < steps; ++i, time += dt) {
            const double middle = piston::START + time + 0.5 * dt;
            box.step(dt, piston::velocity(middle));
            exact.advance(time + 0.5 * dt,
                          [](double t) { return piston::velocity(piston::START + t); });
            wanted += exact.piston_pressure() / steps;
        }
        const double pressure = box.piston_impulse / (BIN * piston::SIDE * piston::SIDE);
        squares += std::pow(pressure / piston::PRESSURE - wanted / piston::PRESSURE, 2) / BINS;
    }
    return std::sqrt(squares);
}

}  // namespace

int main(int argc, char** argv) {
    parallel::set_threads(1);
    std::string csv =
        "model,particles,runs,density,pressure,density_noise,pressure_noise,piston,"
        "cpu_seconds,ns_per_particle_step\n";
    fmt::print(
        "Sod: L1 of the mean of `runs` (what chance alone would make); piston: RMS / p0\n"
        "{:8} {:>8} {:>5} {:>16} {:>16} {:>7} {:>9} {:>8}\n",
        "model", "N", "runs", "density", "pressure", "piston", "s a run", "ns/p/st");
    for (const Setting& setting : SETTINGS)
        for (const std::size_t n :
             {std::size_t{10000}, std::size_t{100000}, std::size_t{1000000}}) {
            if (setting.model == CollisionModel::SPHERES && n > 100000) continue;
            const int runs = runs_of(setting.model, n);
            const oracle::SodError sod =
                oracle::sod_error({setting.model, n, edge_of(setting, n), setting.cfl}, runs);
            const double piston = n > 100000 ? NaN : piston_error(setting, n);
            const double each =
                1e9 * sod.cpu_seconds / (static_cast<double>(n) * static_cast<double>(sod.steps));
            fmt::print("{:8} {:8} {:5} {:7.4f} ({:.4f}) {:7.4f} ({:.4f}) {:7.4f} {:9.3f} {:8.1f}\n",
                       name_of(setting.model), n, runs, sod.density, sod.density_noise,
                       sod.pressure, sod.pressure_noise, piston, sod.cpu_seconds, each);
            std::fflush(stdout);
            csv +=
                fmt::format("{},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.4f},{:.2f}\n",
                            name_of(setting.model), n, runs, sod.density, sod.pressure,
                            sod.density_noise, sod.pressure_noise, piston, sod.cpu_seconds, each);
        }
    if (argc > 1) fmt::output_file(argv[1]).print("{}", csv);
}
