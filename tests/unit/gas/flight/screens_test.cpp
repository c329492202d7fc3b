// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: who sees whom past facets, four of them at a time, is what each facet's plane and edges say
// by themselves, in double precision and one by one.

#include "gas/flight/screens.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "tests/support/draw.hpp"

using namespace corpuscle;
using corpuscle::gas::Screens;

namespace {

struct Facet {
    Vec3 a, b, c;

    [[nodiscard]] int side(const Vec3& p) const {
        const double height = (b - a).cross(c - a).dot(p - a);
        return height > 0.0 ? 1 : -1;
    }
    /// The line from p to q, known to meet the plane.
    [[nodiscard]] bool is_met(const Vec3& p, const Vec3& q) const {
        const Vec3 d = q - p;
        const double ab = d.dot((a - p).cross(b - p)), bc = d.dot((b - p).cross(c - p)),
                     ca = d.dot((c - p).cross(a - p));
        return std::min({ab, bc, ca}) >= 0.0 || std::max({ab, bc, ca}) <= 0.0;
    }
};

bool is_free(const std::vector<Facet>& facets, const Vec3& p, const Vec3& q) {
    for (const Facet& facet : facets)
        if (facet.side(p) != facet.side(q) && facet.is_met(p, q)) return false;
    return true;
}

}  // namespace

TEST_CASE("particles see each other past facets, four at a time as one by one", "[gas][groups]") {
    const auto [particles, count] = GENERATE(table<std::size_t, std::size_t>(
        {{2, 1}, {5, 3}, {13, 4}, {40, 37}, {40, 64}, {23, 65}, {61, 200}}));
    support::Draw draw(static_cast<unsigned>(particles + 1000 * count));
    const auto point = [&] {
        return Vec3(10.0 + 1e-2 * draw.in(0.0, 1.0), -3.0 + 1e-2 * draw.in(0.0, 1.0),
                    1e-2 * draw.in(0.0, 1.0));
    };
    std::vector<Vec3> x;
    for (std::size_t i = 0; i < particles; ++i) x.push_back(point());
    std::vector<Facet> facets;
    Screens screens;
    screens.begin(x, 2e-2);
    for (std::size_t f = 0; f < count; ++f) {
        facets.push_back({point(), point(), point()});
        screens.add(facets.back().a, facets.back().b, facets.back().c);
    }
    std::size_t free = 0;
    for (std::size_t i = 0; i < particles; ++i) {
        CHECK_FALSE(screens.touches(i));
        for (std::size_t j = 0; j < particles; ++j) {
            if (i == j) continue;
            bool are_alike = true;
            for (const Facet& facet : facets) are_alike &= facet.side(x[i]) == facet.side(x[j]);
            CHECK(screens.are_alike(i, j) == are_alike);
            CHECK(screens.is_free(i, j) == is_free(facets, x[i], x[j]));
            free += screens.is_free(i, j);
        }
    }
    if (count == 37) CHECK(free > 0);
}

TEST_CASE("what touches a facet's plane, or its edge, is not told to be free", "[gas][groups]") {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const std::vector<Vec3> x{{0.2, 0.2, 0.0}, {0.2, 0.2, 0.5},  {0.5, 0.5, -0.5},
                              {0.5, 0.5, 0.5}, {0.9, 0.9, -0.5}, {0.9, 0.9, 0.5}};
    Screens screens;
    screens.begin(x, 2.0);
    CHECK(screens.empty());
    screens.add(Vec3(0, 0, 2), Vec3(1, 0, 2), Vec3(0, 1, 2));  // beyond all of them
    CHECK(screens.empty());
    screens.add(a, b, c);
    REQUIRE_FALSE(screens.empty());
    CHECK(screens.touches(0));
    CHECK_FALSE(screens.touches(1));
    CHECK_FALSE(screens.is_free(0, 1));  // one end is in the facet
    CHECK_FALSE(screens.is_free(2, 3));  // along a line through its edge
    CHECK(screens.is_free(4, 5));        // past it
    CHECK(screens.are_alike(1, 3));
    CHECK_FALSE(screens.are_alike(3, 2));
}
