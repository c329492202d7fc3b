// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>

#include "gas/collisions/cell_grid.hpp"
#include "solver/base/parallel.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

TEST_CASE("sorting puts whole particles in the order of cells, on any number of threads", "[gas]") {
    const std::size_t n = GENERATE(0, 1, 50, 30000);
    const int threads = GENERATE(1, 2, 5);
    const Mixture mixture = mixture_of({AIR, HELIUM});
    const Particles before = random_gas(n, Vec3(1, 0.7, 0.3), mixture, {300, 400});
    const Grid grid = Grid::over(Vec3::Zero(), Vec3(1, 0.7, 0.3), 0.11, 1000);

    Particles gas = before;
    parallel::set_threads(threads);
    CellSort sort;
    sort.sort(grid, gas);
    sort.sort(grid, gas);
    parallel::set_threads(2);

    const Lists cells = sort.cells();
    REQUIRE(cells.size() == grid.size());
    REQUIRE(cells.order.size() == n);
    std::size_t seen = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        std::int32_t last = -1;
        for (const Index row : cells[c]) {
            REQUIRE(row == static_cast<Index>(seen++));
            REQUIRE(grid.cell_of(gas.x[row]) == c);
            REQUIRE(gas.id[row] > last);  // stable
            last = gas.id[row];
            const auto old = static_cast<std::size_t>(gas.id[row]);
            REQUIRE(gas.x[row] == before.x[old]);
            REQUIRE(gas.v[row] == before.v[old]);
            REQUIRE(gas.e[row] == before.e[old]);
            REQUIRE(gas.species[row] == before.species[old]);
        }
    }
    CHECK(seen == n);
}

TEST_CASE("a sort that leaves rows where they are lists each in its cell", "[gas]") {
    const Mixture mixture = mixture_of({AIR, HELIUM});
    const Particles before = random_gas(20000, Vec3(1, 0.7, 0.3), mixture, {300, 400});
    const Grid grid = Grid::over(Vec3::Zero(), Vec3(1, 0.7, 0.3), 0.11, 1000);
    Particles gas = before;
    CellSort sort;
    sort.sort(grid, gas, /*moves_rows=*/false);
    CHECK(gas.id == before.id);
    const Lists cells = sort.cells();
    std::size_t seen = 0;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        Index last = -1;
        for (const Index row : cells[c]) {
            REQUIRE(grid.cell_of(gas.x[row]) == c);
            REQUIRE(row > last);
            last = row;
            ++seen;
        }
    }
    CHECK(seen == gas.size());
}
