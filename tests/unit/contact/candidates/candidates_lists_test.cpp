// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include "contact/candidates/candidates.hpp"
#include "tests/support/geometry/brute_force.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

TEST_CASE("cloth that flies without changing builds its lists once", "[contact]") {
    support::Sheet bag = support::two_panels(6, 0.1, 2e-3, true);
    support::SpringCloth cloth(bag);
    const Cloth fixed(cloth.setup({}, bag.x));
    Candidates pairs(fixed, 1.5);
    const Points v(bag.x.size(), Vec3(80, 10, -30));
    const double dt = 1e-5;
    pairs.start(bag.x, v, 0.0, dt, std::vector<std::uint8_t>{1});
    for (int n = 1; n < 90; ++n) {
        for (std::size_t i = 0; i < v.size(); ++i) bag.x[i] += dt * v[i];
        pairs.follow(bag.x, n * dt, dt);
        pairs.foresee(bag.x, v, n * dt, dt);
    }
    CHECK(pairs.builds() <=
          13);  // only the predictions' age, which doubles as none is disappointed
    std::size_t due = 0;
    pairs.for_each_due(0, pairs.size(), [&](std::size_t) { ++due; });
    CHECK(due == 0);
}
