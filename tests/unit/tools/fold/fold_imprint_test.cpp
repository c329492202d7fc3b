// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/mesh/imprint.hpp"
#include "tools/fold/mesh/improve.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

/// n × n quads on [-1, 1]², nodes on the axes (lines 1, 2) and the border (3 to 6) held there.
Sheet square(int n) {
    Sheet s;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) {
            s.X.emplace_back(2.0 * i / n - 1.0, 2.0 * j / n - 1.0, 0.0);
            auto& on = s.on.emplace_back();
            if (2 * i == n) on.push_back(1);
            if (2 * j == n) on.push_back(2);
            if (i % n == 0) on.push_back(i == 0 ? 3 : 4);
            if (j % n == 0) on.push_back(j == 0 ? 5 : 6);
        }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const Index a = j * (n + 1) + i;
            s.cells.push_back({a, a + 1, a + n + 2, a + n + 1});
        }
    s.x = s.X;
    s.part.assign(s.cells.size(), 0);
    return s;
}

double area(const Sheet& s, const std::vector<int>& side, int wanted) {
    double sum = 0.0;
    for (std::size_t e = 0; e < s.cells.size(); ++e)
        if (side[e] == wanted) sum += fold::area(s.cells[e], s.X);
    return sum;
}

double least_quality(const Sheet& s) {
    double least = 1.0;
    for (const Cell& c : s.cells) least = std::min(least, quality(c, s.X));
    return least;
}

Imprint straight(const Sheet& s, const Vec3& normal, double at) {
    Imprint line{7, {}, 0.4, 0.0, {}};
    for (const Vec3& X : s.X) line.level.push_back(normal.dot(X) - at);
    return line;
}

}  // namespace

TEST_CASE("a straight line parts the cells and keeps their area", "[fold]") {
    const double angle = GENERATE(0.0, 0.3, 0.785398, 1.2), at = GENERATE(0.0, 0.013, 0.21);
    Sheet s = square(10);
    const Vec3 normal(std::cos(angle), std::sin(angle), 0.0);
    const std::vector<int> side = imprint(s, straight(s, normal, at));
    REQUIRE(side.size() == s.cells.size());
    for (std::size_t e = 0; e < side.size(); ++e)
        for (const Index n : s.cells[e]) CHECK(side[e] * (normal.dot(s.X[n]) - at) > -1e-12);
    CHECK(area(s, side, 1) + area(s, side, -1) == Approx(4.0));
    CHECK(least_quality(s) > 0.0);
}

TEST_CASE("a line of the mesh is imprinted without changing it", "[fold]") {
    Sheet s = square(10);
    const Sheet before = s;
    const std::vector<int> side = imprint(s, straight(s, Vec3::UnitX(), 0.2));
    CHECK(s.X == before.X);
    CHECK(s.cells == before.cells);
    CHECK(area(s, side, 1) == Approx(1.6));
}

TEST_CASE("a circle is imprinted with its area and without slivers", "[fold]") {
    const double radius = GENERATE(0.31, 0.5, 0.666);
    Sheet s = square(30);
    Imprint line{-1, {}, 0.45, 0.2, [&](Vec3& X) { X *= radius / X.norm(); }};
    for (const Vec3& X : s.X) line.level.push_back(X.norm() - radius);
    const std::vector<int> side = imprint(s, line);
    CHECK(area(s, side, -1) == Approx(std::numbers::pi * radius * radius).epsilon(0.03));
    const double size = 2.0 / 30.0;
    const Freedom freedom{{{-1, line.settle}}, {}};
    smooth(s, 0.28 * size, 8, freedom);
    collapse({0.17 * size}, freedom, s);
    smooth(s, 0.28 * size, 8, freedom);
    CHECK(least_quality(s) > 0.17);  // 10 degrees
    double least = 1.0;
    for (const Cell& c : s.cells) least = std::min(least, reach(c, s.X));
    CHECK(least > 0.17 * size);
    for (std::size_t n = 0; n < s.X.size(); ++n)
        for (const int name : s.on[n])
            if (name == 1 || name == 2)
                CHECK(s.X[n][name - 1] == Approx(0.0).margin(1e-12));  // held on the axes
}

TEST_CASE("what moves or is cut in the plan is where it was in the pack", "[fold]") {
    Sheet s = square(9);
    for (Vec3& x : s.x) x = Vec3(x.y(), -x.x(), 3.0);  // turned and lifted
    imprint(s, straight(s, Vec3(0.6, 0.8, 0.0), 0.1));
    for (std::size_t n = 0; n < s.X.size(); ++n)
        CHECK((s.x[n] - Vec3(s.X[n].y(), -s.X[n].x(), 3.0)).norm() < 1e-12);
}

TEST_CASE("reach is the half's or the whole square's, and an inverted cell has none", "[fold]") {
    const Points X{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
    CHECK(reach({0, 1, 2, 3}, X) == Approx(3.0 / std::sqrt(8.0)));
    CHECK(reach({0, 1, 2, 2}, X) == Approx(3.0 / std::sqrt(12.0)));
    CHECK(reach({0, 2, 1, 1}, X) < 0.0);
}

TEST_CASE("short edges are drawn together, lines and area stay", "[fold]") {
    Sheet s = square(10);
    const Vec3 normal = Vec3(1.0, 0.3, 0.0).normalized();
    Imprint line = straight(s, normal, 0.015);
    line.snap = 0.0;  // so that slivers are left
    imprint(s, line);
    const auto least_reach = [&] {
        double least = 1.0;
        for (const Cell& c : s.cells) least = std::min(least, reach(c, s.X));
        return least;
    };
    const double before = least_reach();
    CHECK(collapse({0.03}, {}, s) > 0);
    CHECK(least_reach() > 1.5 * before);
    CHECK(area(s, std::vector<int>(s.cells.size(), 1), 1) == Approx(4.0));
    drop_loose_nodes(s);
    for (std::size_t n = 0; n < s.X.size(); ++n)
        for (const int name : s.on[n]) {
            if (name == 7) CHECK(normal.dot(s.X[n]) == Approx(0.015).margin(1e-12));
            if (name < 3) CHECK(s.X[n][name - 1] == Approx(0.0).margin(1e-12));
        }
}

TEST_CASE("a piece of more than five corners is refused", "[fold]") {
    const Points hexagon{{2, 0, 0}, {1, 2, 0}, {-1, 2, 0}, {-2, 0, 0}, {-1, -2, 0}, {1, -2, 0}};
    CHECK(best_cells({0, 1, 2, 3, 4}, hexagon).size() >= 2);
    for (const std::vector<Index>& polygon : {std::vector<Index>{0, 1, 2, 3, 4, 5}, {0, 1}, {}})
        CHECK_THROWS_AS(best_cells(polygon, hexagon), InputError);
}
