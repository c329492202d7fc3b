// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>

#include <cmath>

#include "gas/collisions/collide.hpp"
#include "solver/base/parallel.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

namespace {

const Vec3 BOX(1.0, 1.0, 1.0);
constexpr double PER_CELL = 20.0;
constexpr double SHARE = 0.25;  ///< of a cell, crossed between two collisions

/// A closed box of gas at rest on one thread: flight and mirror walls, sort, collisions; one
/// collision step a particle-step.
void closed_box(benchmark::State& state, CollisionModel model, std::vector<SpeciesCard> cards) {
    parallel::set_threads(1);
    const auto n = static_cast<std::size_t>(state.range(0));
    const Mixture mixture = mixture_of(cards);
    Particles gas = random_gas(n, BOX, mixture, std::vector<double>(cards.size(), 300.0));
    Collider collider(mixture.species(), mixture.moles_each(), 1, model);
    const Grid grid =
        Grid::over(Vec3::Zero(), BOX - Vec3::Constant(1e-9), cell_edge(1.0, n, PER_CELL), n);
    const double c_T = std::sqrt(GAS_CONSTANT * 300.0 / mixture.species()[0].molar_mass());
    const double dt = SHARE * grid.edge / c_T;
    std::uint64_t step = 0;
    for (auto _ : state) {
        collider.find_groups(grid, {}, gas);
        collider.collide(step, dt, 1.0, gas);
        drift_in_box(dt, BOX, gas);
        ++step;
    }
    state.counters["particle_steps"] =
        benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}

/// The sort alone.
void sort(benchmark::State& state) {
    parallel::set_threads(1);
    const auto n = static_cast<std::size_t>(state.range(0));
    Particles gas = random_gas(n, BOX, mixture_of({AIR}), {300.0});
    const Grid grid = Grid::over(Vec3::Zero(), BOX, cell_edge(1.0, n, PER_CELL), n);
    const double c_T = std::sqrt(GAS_CONSTANT * 300.0 / AIR.molar_mass);
    CellSort cells;
    for (auto _ : state) {
        state.PauseTiming();
        drift_in_box(SHARE * grid.edge / c_T, BOX, gas);
        state.ResumeTiming();
        cells.sort(grid, gas);
        benchmark::ClobberMemory();
    }
    state.counters["particle_steps"] =
        benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(closed_box, pairs, CollisionModel::PAIRS, {AIR})->Arg(100000)->Arg(1000000);
BENCHMARK_CAPTURE(closed_box, ntc, CollisionModel::NTC, {AIR})->Arg(100000);
BENCHMARK_CAPTURE(closed_box, spheres, CollisionModel::SPHERES, {AIR})->Arg(100000);
BENCHMARK_CAPTURE(closed_box, lin, CollisionModel::LIN, {AIR})->Arg(100000)->Arg(1000000);
BENCHMARK_CAPTURE(closed_box, lin_mixture, CollisionModel::LIN, {AIR, HELIUM})->Arg(100000);
BENCHMARK(sort)->Arg(100000)->Arg(1000000);

}  // namespace

BENCHMARK_MAIN();
