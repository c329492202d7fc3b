// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/collision_cells.hpp"

#include <catch2/catch.hpp>

#include "tests/support/geometry/shapes.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;

TEST_CASE("the time since the last collisions does not run while a bag has no particles", "[gas]") {
    const shapes::Shape box = shapes::box(Vec3::Constant(0.1), 2);
    CollisionCells cells(box.triangles, box.triangles.size(), box.x, 1e-3, 1000, 300.0);
    constexpr double DT = 1e-6, DELAY = 5e-3;
    for (double t = 0.0; t < DELAY; t += DT) {
        (void)cells.is_due(DT);
        cells.pass_empty();
    }
    CHECK(cells.is_due(DT));  // it is high time for those that come
    CHECK(cells.since() == Approx(DT));
    Particles gas;
    gas.add({0.05, 0.05, 0.05}, {300, 0, 0}, 0.0, 0, 0);
    cells.finish(Lists(), std::vector<double>{1e-6}, gas);
    CHECK_FALSE(cells.is_due(DT));
    CHECK(cells.since() == DT);
}
