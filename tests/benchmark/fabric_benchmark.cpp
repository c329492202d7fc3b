// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <benchmark/benchmark.h>
#include <malloc.h>

#include "solver/base/parallel.hpp"
#include "tests/unit/fabric/sheet.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

enum class Cloth { LINEAR, NO_COMPRESSION, DAMPED, LINED, CURVES, LOOPS };

FabricCard card(Cloth cloth) {
    FabricCard c = fabric_card();
    c.no_compression = cloth == Cloth::NO_COMPRESSION;
    c.damping = cloth == Cloth::DAMPED ? 0.05 : 0.0;
    c.liner_E = 20e6;
    c.liner_ratio = cloth == Cloth::LINED ? 0.1 : 0.0;
    if (cloth == Cloth::CURVES || cloth == Cloth::LOOPS) {
        c.form = 14;
        c.curves.load = {0, 0, -1};
        if (cloth == Cloth::LOOPS) c.curves.unload = {1, 1, -1};
    }
    return c;
}

const std::vector<Curve> CURVES = {{1, {0.0, 0.01, 0.05, 0.3}, {0.0, 1e6, 9e6, 80e6}},
                                   {2, {0.0, 0.1, 0.3}, {0.0, 5e6, 80e6}}};

/// What the program has allocated.                                                     [bytes]
double allocated() {
    const struct mallinfo2 now = mallinfo2();
    return static_cast<double>(now.uordblks + now.hblkhd);
}

/// Force of 10 000 elements on one thread. Half of the sheet is stretched, half wrinkled.
void membrane_force(benchmark::State& state, Mesh mesh, Cloth cloth) {
    parallel::set_threads(1);
    const int rows = mesh == Mesh::TRIANGLES ? 50 : 100;
    Sheet sheet = rectangle(card(cloth), mesh, 100, rows, 1.0, 1.0);
    jitter(sheet, 0.001);
    sheet.curves = CURVES;
    const MembraneSetup setup = sheet.setup();
    const double before = allocated();
    Membranes membranes(setup);
    const double bytes = allocated() - before;
    const Points x = moved(sheet.x, [](const Vec3& p) {
        return Vec3(1.01 * p.x(), p.y() * (p.x() < 0.5 ? 1.005 : 0.97), 0.01 * std::sin(9 * p.x()));
    });
    const Points v = noise(x.size(), 1.0, 1);
    Points f = zeros(x.size());
    for (auto _ : state) {
        benchmark::DoNotOptimize(membranes.add_force(x, v, f));
        benchmark::ClobberMemory();
    }
    state.counters["bytes_per_element"] = bytes / static_cast<double>(membranes.element_count());
    state.counters["element_steps"] =
        benchmark::Counter(static_cast<double>(membranes.element_count()),
                           benchmark::Counter::kIsIterationInvariantRate);
}

BENCHMARK_CAPTURE(membrane_force, triangle, Mesh::TRIANGLES, Cloth::LINEAR);
BENCHMARK_CAPTURE(membrane_force, triangle_no_compression, Mesh::TRIANGLES, Cloth::NO_COMPRESSION);
BENCHMARK_CAPTURE(membrane_force, triangle_damped, Mesh::TRIANGLES, Cloth::DAMPED);
BENCHMARK_CAPTURE(membrane_force, triangle_lined, Mesh::TRIANGLES, Cloth::LINED);
BENCHMARK_CAPTURE(membrane_force, triangle_curves, Mesh::TRIANGLES, Cloth::CURVES);
BENCHMARK_CAPTURE(membrane_force, triangle_loops, Mesh::TRIANGLES, Cloth::LOOPS);
BENCHMARK_CAPTURE(membrane_force, quad_one_point, Mesh::ONE_POINT, Cloth::LINEAR);
BENCHMARK_CAPTURE(membrane_force, quad_one_point_no_compression, Mesh::ONE_POINT,
                  Cloth::NO_COMPRESSION);
BENCHMARK_CAPTURE(membrane_force, quad_one_point_damped, Mesh::ONE_POINT, Cloth::DAMPED);
BENCHMARK_CAPTURE(membrane_force, quad_four_point, Mesh::FOUR_POINT, Cloth::LINEAR);
BENCHMARK_CAPTURE(membrane_force, quad_four_point_no_compression, Mesh::FOUR_POINT,
                  Cloth::NO_COMPRESSION);

}  // namespace

BENCHMARK_MAIN();
