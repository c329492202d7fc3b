// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <Eigen/Geometry>

#include "tools/check/crossing_depth.hpp"

using namespace corpuscle;
using tools::crossing_depth;
using tools::Prism;

namespace {

/// The tip of an upright facet goes through a lying one by `depth`.
std::pair<Prism, Prism> pierced(double depth, double thickness) {
    return {{{Vec3(-1.0, -1.0, 0.0), Vec3(1.0, -1.0, 0.0), Vec3(0.0, 1.0, 0.0)}, thickness},
            {{Vec3(-0.2, 0.0, 0.5), Vec3(0.2, 0.0, 0.5), Vec3(0.0, 0.0, -depth)}, thickness}};
}

}  // namespace

TEST_CASE("two facets that cross must be moved apart by their depth", "[contact]") {
    for (const double depth : {0.002, 0.05, 0.2}) {
        const auto [lying, upright] = pierced(depth, 1e-3);
        CHECK(crossing_depth(lying, upright) == Approx(depth + 5e-4).epsilon(1e-3));
        CHECK(crossing_depth(upright, lying) == Approx(depth + 5e-4).epsilon(1e-3));
    }
    const auto [lying, upright] = pierced(-0.01, 1e-3);
    CHECK(crossing_depth(lying, upright) == 0.0);
}

TEST_CASE("depth is the same in any place and direction", "[contact]") {
    auto [lying, upright] = pierced(0.03, 1e-3);
    const Eigen::AngleAxisd turn(0.7, Vec3(1.0, 2.0, -0.5).normalized());
    for (Prism* prism : {&lying, &upright})
        for (Vec3& x : prism->corners) x = turn * x + Vec3(300.0, -200.0, 50.0);
    CHECK(crossing_depth(lying, upright) == Approx(0.0305).epsilon(1e-3));
}
