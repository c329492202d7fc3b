// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/coinciding.hpp"

#include <catch2/catch.hpp>

#include "tests/support/geometry/cloth.hpp"

using namespace corpuscle;
using support::Sheet;
using support::square_sheet;

namespace {
constexpr double LIFT = 1e-6;
}

TEST_CASE("panels of a flat bag part along their normals, their seam stays", "[contact]") {
    const Sheet bag = support::two_panels(6, 0.06, 0.0, /*is_seamed=*/true);
    const Points lifts = contact::lifts_of_coinciding(bag.triangles, bag.x, LIFT);
    REQUIRE(lifts.size() == bag.x.size());
    for (std::size_t n = 0; n < lifts.size(); ++n) {
        const Vec3& x = bag.x[n];
        const bool is_rim = std::min({x.x(), x.y(), 0.06 - x.x(), 0.06 - x.y()}) < 1e-9;
        if (is_rim) continue;
        const double side = n < 49 ? -1.0 : 1.0;  // the lower panel's normals look down
        CHECK((lifts[n] - Vec3(0, 0, side * LIFT)).norm() < 1e-12);
    }
    for (std::size_t n = 0; n < 49; ++n)
        if (std::min(bag.x[n].x(), bag.x[n].y()) < 1e-9)
            CHECK(lifts[n].norm() < LIFT);  // both panels pull
}

TEST_CASE("a heap of layers in one place keeps their order", "[contact]") {
    Sheet heap = square_sheet(6, 0.06);
    for (int l = 0; l < 3; ++l) heap.append(square_sheet(5 + l, 0.06), Vec3::Zero());
    const Points lifts = contact::lifts_of_coinciding(heap.triangles, heap.x, LIFT);
    REQUIRE(lifts.size() == heap.x.size());
    const std::size_t first[] = {0, 49, 49 + 36, 49 + 36 + 49, 49 + 36 + 49 + 64};
    double below = -INF;
    for (int l = 0; l < 4; ++l) {
        double least = INF, most = -INF;
        for (std::size_t n = first[l]; n < first[l + 1]; ++n) {
            least = std::min(least, lifts[n].z());
            most = std::max(most, lifts[n].z());
        }
        CHECK(least > below);
        below = most;
    }
}

TEST_CASE("cloth beside other cloth, or a gap above it, does not coincide", "[contact]") {
    Sheet both = square_sheet(4, 0.04);
    SECTION("beside") {
        both.append(square_sheet(4, 0.04), {0.04, 0.0, 0.0});
    }
    SECTION("above") {
        both.append(square_sheet(4, 0.04), {0.0, 0.0, 2.0 * LIFT});
    }
    CHECK(contact::lifts_of_coinciding(both.triangles, both.x, LIFT).empty());
}
