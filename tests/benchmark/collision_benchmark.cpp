// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Run time against error of all collision models, one thread: Sod's tube, two pistons, mixing.
// Prints one table; `benchmark_collisions FILE.csv [MODEL ...]` writes it too
// (tools/figures/collisions.py), of some models only if they are named.

#include <fmt/format.h>
#include <fmt/os.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "gas/cards/collision_model.hpp"
#include "solver/base/parallel.hpp"
#include "tests/benchmark/collision_cases.hpp"
#include "tests/support/gas/sod.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;
using corpuscle::benchmark::Setting;

namespace {

constexpr Setting SETTINGS[] = {
    {CollisionModel::LIN, 60.0, 20.0, 0.1},
    {CollisionModel::PAIRS, 100.0, 10.0, 0.25},
    {CollisionModel::NTC, 100.0, 10.0, 0.25},
    {CollisionModel::SPHERES, 60.0, 10.0, 0.1},
};

constexpr std::size_t SIZES[] = {10000, 100000, 1000000};

/// Spheres take ten minutes and more a case.
bool is_too_slow(const Setting& setting, std::size_t n) {
    return setting.model == CollisionModel::SPHERES && n > 100000;
}

/// Runs in the ensemble: as many as keep the whole below four minutes; fewer of the slow models.
int runs_of(CollisionModel model, std::size_t n) {
    if (n > 100000) return model == CollisionModel::LIN ? 8 : 2;
    if (n == 100000 && model == CollisionModel::LIN)
        return 64;  // chance below a fifth of the error
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

bool is_asked_for(const Setting& setting, const std::vector<std::string>& models) {
    return models.empty() ||
           std::find(models.begin(), models.end(), name_of(setting.model)) != models.end();
}

}  // namespace

int main(int argc, char** argv) {
    parallel::set_threads(1);
    const std::vector<std::string> models(argv + std::min(argc, 2), argv + argc);
    std::string csv =
        "model,particles,runs,density,pressure,density_noise,pressure_noise,piston,compression,"
        "mixing,mixing_steps,cpu_seconds,ns_per_particle_step\n";
    fmt::print(
        "Sod: L1 of the mean of `runs` (what chance alone would make); pistons: RMS / p0; mixing:\n"
        "error of temperatures, steps to 1 %\n"
        "{:8} {:>8} {:>5} {:>16} {:>16} {:>7} {:>8} {:>7} {:>6} {:>9} {:>8}\n",
        "model", "N", "runs", "density", "pressure", "piston", "compress", "mixing", "to 1%",
        "s a run", "ns/p/st");
    for (const Setting& setting : SETTINGS)
        for (const std::size_t n : SIZES) {
            if (!is_asked_for(setting, models) || is_too_slow(setting, n)) continue;
            const int runs = runs_of(setting.model, n);
            const oracle::SodError sod =
                oracle::sod_error({setting.model, n, edge_of(setting, n), setting.cfl}, runs);
            const double piston = benchmark::fast_piston_error(setting, n);
            const double compression = benchmark::compression_error(setting, n);
            const benchmark::Mixing mixing = benchmark::mixing_error(setting, n);
            const double each =
                1e9 * sod.cpu_seconds / (static_cast<double>(n) * static_cast<double>(sod.steps));
            fmt::print(
                "{:8} {:8} {:5} {:7.4f} ({:.4f}) {:7.4f} ({:.4f}) {:7.4f} {:8.4f} {:7.4f} {:6} "
                "{:9.3f} {:8.1f}\n",
                name_of(setting.model), n, runs, sod.density, sod.density_noise, sod.pressure,
                sod.pressure_noise, piston, compression, mixing.error, mixing.step_to_1,
                sod.cpu_seconds, each);
            std::fflush(stdout);
            csv += fmt::format(
                "{},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{},"
                "{:.4f},{:.2f}\n",
                name_of(setting.model), n, runs, sod.density, sod.pressure, sod.density_noise,
                sod.pressure_noise, piston, compression, mixing.error, mixing.step_to_1,
                sod.cpu_seconds, each);
        }
    if (argc > 1) fmt::output_file(argv[1]).print("{}", csv);
}
