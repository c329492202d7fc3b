// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <cmath>
#include <random>

#include "contact/broad_phase/intersections.hpp"
#include "contact/geometry/orientation.hpp"
#include "tests/support/geometry/brute_force.hpp"
#include "tests/support/geometry/cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {
const Vec3 A(0, 0, 0), B(1, 0, 0), C(0, 1, 0);
}

TEST_CASE("orientation is positive on the normal's side and exact next to the plane", "[contact]") {
    CHECK(orientation(A, B, C, {0.3, 0.3, 1.0}) == 1);
    CHECK(orientation(A, B, C, {0.3, 0.3, -1.0}) == -1);
    CHECK(orientation(A, B, C, {5.0, -7.0, 0.0}) == 0);

    // a plane through points whose coordinates are rounded; the nearest doubles on either side of
    // it
    const Vec3 far(1e8, 1e8, 1e8);
    const Vec3 a = far, b = far + Vec3(1, 0, 1), c = far + Vec3(0, 1, 1), on = far + Vec3(1, 1, 2);
    CHECK(orientation(a, b, c, on) == 0);
    Vec3 up = on, down = on;
    up.z() = std::nextafter(on.z(), INF);
    down.z() = std::nextafter(on.z(), -INF);
    CHECK(orientation(a, b, c, up) == 1);
    CHECK(orientation(a, b, c, down) == -1);
}

TEST_CASE("orientation turns its sign with every swap of two points, however degenerate",
          "[contact]") {
    std::mt19937 random(3);
    std::uniform_int_distribution<int> small(0, 3);
    int zeros = 0;
    for (int i = 0; i < 2000; ++i) {
        // thirds are rounded: collinear and coplanar points are so only nearly
        std::array<Vec3, 4> p;
        for (Vec3& q : p)
            q = Vec3(small(random), small(random), small(random)) / 3.0 + Vec3(7, 11, 13) / 9.0;
        const int sign = orientation(p[0], p[1], p[2], p[3]);
        zeros += sign == 0;
        REQUIRE(orientation(p[1], p[0], p[2], p[3]) == -sign);
        REQUIRE(orientation(p[0], p[2], p[1], p[3]) == -sign);
        REQUIRE(orientation(p[3], p[1], p[2], p[0]) == -sign);
    }
    CHECK(zeros > 0);
}

TEST_CASE("a segment crosses only the inside of a triangle", "[contact]") {
    const auto crosses = [](const Vec3& p, const Vec3& q) {
        return segment_crosses(p, q, A, B, C);
    };
    CHECK(crosses({0.2, 0.2, -1}, {0.2, 0.2, 1}));
    CHECK(crosses({0.2, 0.2, 1}, {0.2, 0.2, -1}));
    CHECK_FALSE(crosses({0.2, 0.2, 1e-300}, {0.2, 0.2, 1}));
    CHECK(crosses({0.2, 0.2, -1e-300}, {0.2, 0.2, 1}));
    CHECK_FALSE(crosses({0.2, 0.2, 0}, {0.2, 0.2, 1}));   // touches with its end
    CHECK_FALSE(crosses({0.2, 0.0, -1}, {0.2, 0.0, 1}));  // through an edge
    CHECK_FALSE(crosses({0, 0, -1}, {0, 0, 1}));          // through a corner
    CHECK_FALSE(crosses({0.8, 0.8, -1}, {0.8, 0.8, 1}));  // beside it
    CHECK_FALSE(crosses({0.1, 0.1, 0}, {0.3, 0.3, 0}));   // in the plane
}

TEST_CASE("crossings by patches are those of brute force on crumpled, moving cloth", "[contact]") {
    support::Sheet sheet = support::square_sheet(16, 1.0);
    const Patches patches = make_patches(sheet.x, sheet.triangles, 16);
    CHECK(crossings(sheet.triangles, patches, sheet.x).empty());

    const Points flat = sheet.x;
    std::size_t found = 0;
    for (int frame = 0; frame < 20; ++frame) {
        const double a = 0.05 + 0.02 * frame;  // waves so high that the sheet meets itself
        for (std::size_t i = 0; i < flat.size(); ++i) {
            const double x = flat[i].x(), y = flat[i].y();
            sheet.x[i] = Vec3(x + a * std::sin(13 * y + frame), y + a * std::sin(17 * x),
                              a * std::cos(11 * x + 9 * y));
        }
        const auto expected = brute_force::crossings(sheet.triangles, sheet.x);
        REQUIRE(crossings(sheet.triangles, patches, sheet.x) == expected);
        found += expected.size();
    }
    CHECK(found > 100);
}

TEST_CASE("two panels that touch do not cross, until one corner dips through", "[contact]") {
    support::Sheet bag = support::two_panels(8, 0.6, 0.0, true);
    const Patches patches = make_patches(bag.x, bag.triangles);
    CHECK(crossings(bag.triangles, patches, bag.x).empty());
    // an upper node just below the lower panel, and not straight below a lower node
    bag.x.back() += Vec3(1e-3, 2e-3, -1e-12);
    for (std::size_t i = 81; i + 1 < bag.x.size(); ++i) bag.x[i].z() = 1e-6;
    CHECK_FALSE(crossings(bag.triangles, patches, bag.x).empty());
}
