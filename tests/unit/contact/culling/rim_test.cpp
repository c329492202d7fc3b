// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "contact/culling/rim.hpp"
#include "contact/geometry/distance.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

/// A closed line at a distance from the origin that changes at random.
Points star(std::size_t corners, double depth, std::mt19937& random) {
    std::uniform_real_distribution<double> one(1.0 - depth, 1.0);
    Points x;
    for (std::size_t i = 0; i < corners; ++i) {
        const double angle =
            2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners);
        x.emplace_back(one(random) * Vec3(std::cos(angle), std::sin(angle), 0.0));
    }
    return x;
}

PlanePoints flat(const Points& x) {
    PlanePoints at;
    for (const Vec3& p : x) {
        at.x.push_back(static_cast<float>(p.x()));
        at.y.push_back(static_cast<float>(p.y()));
    }
    return at;
}

/// Least distance of corners from edges that do not have them.
double least_distance(const Points& x) {
    double least = INF;
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < x.size(); ++j) {
            const std::size_t k = (j + 1) % x.size();
            if (i == j || i == k) continue;
            const Vec3 along = x[k] - x[j];
            const double share =
                std::clamp((x[i] - x[j]).dot(along) / along.squaredNorm(), 0.0, 1.0);
            least = std::min(least, (x[i] - x[j] - share * along).norm());
        }
    return least;
}

bool crosses_itself(const Points& x) {
    const auto side = [&](std::size_t of, std::size_t from, std::size_t to) {
        return (x[to] - x[from]).cross(x[of] - x[from]).z() > 0.0;
    };
    for (std::size_t i = 0; i < x.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const std::size_t k = (i + 1) % x.size(), m = (j + 1) % x.size();
            if (i == m || j == k) continue;
            if (side(i, j, m) != side(k, j, m) && side(j, i, k) != side(m, i, k)) return true;
        }
    return false;
}

}  // namespace

TEST_CASE("a rim is one closed line, or none", "[contact]") {
    std::vector<Index> forks;
    const std::vector<Triangle> square{{0, 1, 2}, {0, 2, 3}};
    CHECK(rim_of(square, forks) == std::vector<Index>{0, 1, 2, 3});
    SECTION("one triangle is the other way round") {
        CHECK(rim_of(std::vector<Triangle>{{0, 1, 2}, {0, 3, 2}}, forks).empty());
    }
    SECTION("two pieces") {
        CHECK(rim_of(std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}, forks).empty());
        CHECK(forks.empty());
    }
    SECTION("two pieces with a corner in common") {
        CHECK(rim_of(std::vector<Triangle>{{0, 1, 2}, {2, 3, 4}}, forks).empty());
        CHECK(forks == std::vector<Index>{2});
    }
    SECTION("a closed surface") {
        const std::vector<Triangle> tetrahedron{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
        CHECK(rim_of(tetrahedron, forks).empty());
    }
    SECTION("round a hole") {
        std::vector<Triangle> ring;
        for (Index i = 0; i < 6; ++i) {
            const Index next = (i + 1) % 6;
            ring.push_back({i, next, 6 + i});
            ring.push_back({next, 6 + next, 6 + i});
        }
        CHECK(rim_of(ring, forks).empty());
    }
}

TEST_CASE("heights of triangles in the plane", "[contact]") {
    const PlanePoints at = flat({{0, 0, 0}, {4, 0, 0}, {0, 3, 0}, {4, 3, 0}});
    CHECK(least_height_square(at, std::vector<Triangle>{{0, 1, 2}}) == Approx(2.4 * 2.4));
    CHECK(least_height_square(at, std::vector<Triangle>{{0, 1, 2}, {1, 2, 3}}) == 0.0F);
    CHECK(least_height_square(at, std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}}) ==
          Approx(2.4 * 2.4));
}

TEST_CASE("distance of a rim from itself is that of all its corners from all edges", "[contact]") {
    std::mt19937 random(1);
    for (std::size_t corners = 3; corners < 160; corners += corners < 40 ? 1 : 17)
        for (const double depth : {0.0, 0.5, 0.95}) {
            const Points x = star(corners, depth, random);
            const double least = least_distance(x);
            for (const double most : {INF, 1.5 * least, 0.5 * least})
                CHECK(std::sqrt(
                          rim_distance_square(flat(x), corners, static_cast<float>(most * most))) ==
                      Approx(std::min(least, most)).epsilon(1e-4).margin(1e-6));
        }
}

TEST_CASE("a rim that crosses itself has no distance", "[contact]") {
    const Points eight{{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 4, 0}};
    CHECK(rim_distance_square(flat(eight), 4, INFINITY) == 0.0F);
    std::mt19937 random(2);
    std::size_t crossing = 0, simple = 0;
    for (std::size_t corners = 8; corners < 160; corners += corners < 40 ? 1 : 17)
        for (std::size_t changed = 0; changed + 1 < corners; changed += 3) {
            Points x = star(corners, 0.6, random);
            std::swap(x[changed], x[changed + 1]);
            (crosses_itself(x) ? crossing : simple) += 1;
            for (const float most : {INFINITY, 1e-6F})
                CHECK((rim_distance_square(flat(x), corners, most) == 0.0F) == crosses_itself(x));
        }
    CHECK(crossing > 50);
    CHECK(simple > 50);
}
