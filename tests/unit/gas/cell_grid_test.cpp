// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>

#include "gas/cell_grid.hpp"
#include "random_gas.hpp"
#include "solver/base/parallel.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

TEST_CASE("sorting puts every particle in its own cell, by rows, on any number of threads",
          "[gas]") {
    const std::size_t n = GENERATE(0, 1, 50, 30000);
    const int threads = GENERATE(1, 2, 5);
    const Particles gas = random_gas(n, Vec3(1, 0.7, 0.3), mixture_of({AIR}), {300});
    const Grid grid = Grid::over(Vec3::Zero(), Vec3(1, 0.7, 0.3), 0.11, 1000);

    parallel::set_threads(threads);
    CellSort sort;
    sort.sort(grid, gas.x);
    sort.sort(grid, gas.x);
    parallel::set_threads(2);

    const Lists cells = sort.cells();
    REQUIRE(cells.size() == grid.size());
    REQUIRE(cells.order.size() == n);
    std::size_t seen = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto rows = cells[c];
        CHECK(std::is_sorted(rows.begin(), rows.end()));
        for (const Index row : rows) CHECK(grid.cell_of(gas.x[row]) == c);
        seen += rows.size();
    }
    CHECK(seen == n);
}

TEST_CASE("reordering moves whole particles", "[gas]") {
    const Mixture mixture = mixture_of({AIR, HELIUM});
    Particles gas = random_gas(5000, Vec3(1, 1, 1), mixture, {300, 400});
    const Particles before = gas;
    CellSort sort;
    const Grid grid = Grid::over(Vec3::Zero(), Vec3(1, 1, 1), 0.2, 1000);
    sort.sort(grid, gas.x);
    Particles scratch;
    reorder(sort.cells().order, gas, scratch);
    for (std::size_t i = 0; i < gas.size(); ++i) {
        const auto old = static_cast<std::size_t>(gas.id[i]);
        REQUIRE(gas.x[i] == before.x[old]);
        REQUIRE(gas.v[i] == before.v[old]);
        REQUIRE(gas.e[i] == before.e[old]);
        REQUIRE(gas.species[i] == before.species[old]);
        if (i > 0) REQUIRE(grid.cell_of(gas.x[i]) >= grid.cell_of(gas.x[i - 1]));
    }
}
