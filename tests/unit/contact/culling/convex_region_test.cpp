// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <random>

#include "contact/culling/convex_region.hpp"

using namespace corpuscle::contact;

namespace {

Vec2 any_point(std::mt19937& random) {
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    const double x = any(random);
    return {x, any(random)};
}

}  // namespace

TEST_CASE("the triangles of a plane hold all of a convex region, each its part", "[contact]") {
    std::mt19937 random(5);
    for (int n = 0; n < 50; ++n) {
        std::vector<Vec2> points;
        for (int i = 0; i < 12; ++i) points.push_back(any_point(random));
        const ConvexRegion region(points);
        double sum = 0.0;
        constexpr int CELLS = 9;
        for (int i = 0; i < CELLS; ++i)
            for (int j = 0; j < CELLS; ++j) {
                const auto at = [&](int a, int b) {
                    return Vec2(-1.1 + 2.2 * (i + a) / CELLS, -1.1 + 2.2 * (j + b) / CELLS);
                };
                for (const std::array<Vec2, 3>& t :
                     {std::array{at(0, 0), at(1, 0), at(1, 1)}, {at(1, 1), at(0, 1), at(0, 0)}}) {
                    const double whole = 0.5 * 2.2 * 2.2 / CELLS / CELLS;
                    const double within = region.area_within(t);
                    const auto part = region.part_within(t);
                    if (part == ConvexRegion::Part::ALL)
                        CHECK(within == Approx(whole).epsilon(1e-12));
                    if (part == ConvexRegion::Part::NONE) CHECK(within < 1e-15);
                    sum += within;
                }
            }
        CHECK(sum == Approx(region.area()).epsilon(1e-12));
    }
}

TEST_CASE("a way crosses a convex region where points of it lie within", "[contact]") {
    std::mt19937 random(6);
    int crossed = 0;
    for (int n = 0; n < 500; ++n) {
        const std::vector<Vec2> corners{any_point(random), any_point(random), any_point(random)};
        const ConvexRegion region(corners);
        const Vec2 a = 2.0 * any_point(random), b = 2.0 * any_point(random);
        const auto is_within = [&](const Vec2& p) {  // by signs of areas
            int sides = 0;
            for (int k = 0; k < 3; ++k) {
                const Vec2 u = corners[(k + 1) % 3] - corners[k], w = p - corners[k];
                sides += u.x() * w.y() - u.y() * w.x() > 0.0 ? 1 : -1;
            }
            return std::abs(sides) == 3;
        };
        bool is_any = false;
        for (int i = 0; i <= 2000; ++i) is_any |= is_within(a + i / 2000.0 * (b - a));
        if (is_any) CHECK(region.is_crossed(a, b));
        crossed += region.is_crossed(a, b);
        if (!region.is_crossed(a, b)) CHECK_FALSE(is_any);
    }
    CHECK(crossed > 50);
    CHECK(crossed < 300);
}

TEST_CASE("a way along a region's border does not cross it", "[contact]") {
    const ConvexRegion square({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    CHECK(square.area() == Approx(1.0));
    CHECK_FALSE(square.is_crossed({-1, 0}, {2, 0}));
    CHECK_FALSE(square.is_crossed({0.2, 1}, {0.7, 1}));
    CHECK(square.is_crossed({-1, 1e-6}, {2, 1e-6}));
    CHECK(square.is_crossed({0.2, 0.2}, {0.3, 0.2}));
}
