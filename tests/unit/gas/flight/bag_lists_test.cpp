// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>

#include "gas/flight/bag_lists.hpp"
#include "solver/base/random.hpp"
#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

TEST_CASE("fitted cells are as many as come nearest to each length, and none at a face is a sliver",
          "[gas]") {
    Random draw(7, Stream::INITIAL, 0, 0);
    for (int i = 0; i < 200; ++i) {
        const Vec3 low(draw.uniform(), draw.uniform(), draw.uniform());
        const Vec3 size =
            Vec3(draw.uniform(), draw.uniform(), draw.uniform()) + Vec3::Constant(0.1);
        const double edge = 0.01 + 0.09 * draw.uniform();
        const Grid grid = Grid::fitted(low, low + size, edge, 10'000'000);
        REQUIRE(grid.edge == edge);
        for (int a = 0; a < 3; ++a) {
            const double lengths = size[a] / edge;
            CHECK(grid.count[a] == std::max(1, static_cast<int>(lengths + 0.5)));
            // What the first and the last cell cover of the box
            const double first = grid.low[a] + edge - low[a],
                         last = low[a] + size[a] - (grid.low[a] + edge * (grid.count[a] - 1));
            if (grid.count[a] == 1) continue;
            CHECK(first == Approx(last));
            CHECK(first > 0.74 * edge);
            CHECK(first < 1.26 * edge);
        }
    }
    for (int i = 0; i < 1000; ++i) {  // flatter than a cell: one, whatever the rounding
        const Vec3 low(draw.uniform(), draw.uniform(), draw.uniform());
        const Vec3 thin(0.01 * draw.uniform(), 0.01 * draw.uniform(), 0.01 * draw.uniform());
        REQUIRE(Grid::fitted(low, low + thin, 0.1, 1000).size() == 1);
    }
    const Grid flat = Grid::fitted(Vec3::Zero(), Vec3(1.0, 1.0, 0.0), 0.1, 1000);
    CHECK(flat.count == std::array<int, 3>{10, 10, 1});
    CHECK(Grid::fitted(Vec3::Zero(), Vec3::Ones(), 0.01, 1000).size() <= 1000);
}

TEST_CASE("a cell of a fitted grid lists all fabric in it, beyond the grid's faces too", "[gas]") {
    constexpr int PARTS = 8;
    for (const double edge : {0.13, 0.06, 0.031}) {
        const shapes::Shape shape = shapes::box(Vec3(0.5, 0.31, 0.17), 7);
        FacetLists lists(shape.triangles, shape.x, FacetLists::Of::FACETS);
        build_fitted_to_bag(lists, edge, 0.1 * edge, shape.x);
        int beyond = 0;
        for (std::size_t f = 0; f < shape.triangles.size(); ++f) {
            const auto& [a, b, c] = shape.triangles[f];
            for (int i = 0; i <= PARTS; ++i)
                for (int j = 0; i + j <= PARTS; ++j) {
                    const Vec3 x =
                        (i * shape.x[a] + j * shape.x[b] + (PARTS - i - j) * shape.x[c]) / PARTS;
                    const auto found = lists.in(lists.grid().cell_of(x));
                    REQUIRE(std::find(found.begin(), found.end(), static_cast<Index>(f)) !=
                            found.end());
                    beyond += ((x - lists.grid().low).array() < 0.0).any();
                }
        }
        CHECK(beyond > 0);
    }
}
