// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/moves/accordion.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>

#include "solver/base/error.hpp"

using namespace corpuscle;
using namespace corpuscle::fold;

namespace {

constexpr double GAP = 1.0;

Accordion zigzag(double angle = 0.0) {
    Accordion f;
    f.angle = angle;
    f.lines = {20.0, 60.0, 100.0};
    f.bands = {8.0, 8.0, 8.0};
    f.name = "a zigzag";
    return f;
}

/// Points along s at height z: from -50 to 130, with all borders among them.
Points layer(double z) {
    Points x;
    for (double s = -50.0; s <= 130.0; s += 1.0) x.emplace_back(s, 0.0, z);
    return x;
}

Points both_layers() {
    Points x = layer(-0.5);
    const Points upper = layer(0.5);
    x.insert(x.end(), upper.begin(), upper.end());
    return x;
}

double length(const Points& x, std::size_t first, std::size_t last) {
    double sum = 0.0;
    for (std::size_t n = first; n < last; ++n) sum += (x[n + 1] - x[n]).norm();
    return sum;
}

}  // namespace

TEST_CASE("a zigzag mirrors strips and stacks them a gap apart", "[fold]") {
    Points x = both_layers();
    apply(zigzag(), GAP, x);
    const std::size_t upper = x.size() / 2;
    const auto at = [](double s) { return static_cast<std::size_t>(s + 50.0); };
    CHECK(x[at(0.0)] == Vec3(0.0, 0.0, -0.5));  // left of the first line nothing moves
    CHECK((x[at(40.0)] - Vec3(0.0, 0.0, 2.5)).norm() < 1e-12);  // turned over: back on top
    CHECK((x[upper + at(40.0)] - Vec3(0.0, 0.0, 1.5)).norm() <
          1e-12);  // front below, a gap above it
    CHECK((x[at(80.0)] - Vec3(0.0, 0.0, 3.5)).norm() < 1e-12);
    CHECK((x[upper + at(120.0)] - Vec3(0.0, 0.0, 5.5)).norm() < 1e-12);
}

TEST_CASE("a fold stretches no layer, and keeps the length of the outermost", "[fold]") {
    Points x = both_layers();
    apply(zigzag(), GAP, x);
    const std::size_t upper = x.size() / 2;
    for (std::size_t n = 0; n + 1 < x.size(); ++n)
        if (n + 1 != upper) CHECK((x[n + 1] - x[n]).norm() < 1.0 + 1e-12);
    CHECK(length(x, 62, 78) == Approx(16.0));                    // lower layer round the first line
    CHECK(length(x, upper + 62, upper + 78) < 15.0);             // the upper one is inside
    CHECK(length(x, upper + 102, upper + 118) == Approx(16.0));  // and outside at the second
}

TEST_CASE("layers keep their order along every fibre of a bend", "[fold]") {
    Points x = both_layers();
    apply(zigzag(), GAP, x);
    const std::size_t upper = x.size() / 2;
    double least = INF;
    for (std::size_t i = 0; i + 1 < upper; ++i)
        for (std::size_t j = upper; j + 1 < x.size(); ++j) {
            // segments i, i+1 of the one and j, j+1 of the other in the plane s, z
            const auto side = [&](std::size_t a, std::size_t b, std::size_t c) {
                const Vec3 n = (x[b] - x[a]).cross(x[c] - x[a]);
                return n.y();
            };
            const bool cross = side(i, i + 1, j) * side(i, i + 1, j + 1) < 0.0 &&
                               side(j, j + 1, i) * side(j, j + 1, i + 1) < 0.0;
            CHECK_FALSE(cross);
            least = std::min(least, (x[i] - x[j]).norm());
        }
    CHECK(least > 0.3 * GAP);
}

TEST_CASE("folding in another frame is folding the same", "[fold]") {
    const double angle = GENERATE(0.0, 0.5 * std::numbers::pi, 2.0);
    const bool is_left = GENERATE(false, true), is_down = GENERATE(false, true);
    Accordion f = zigzag(angle);
    f.is_left = is_left;
    f.is_down = is_down;
    Mat3 turn;
    turn << (is_left ? -1.0 : 1.0) * std::cos(angle), -std::sin(angle), 0.0,
        (is_left ? -1.0 : 1.0) * std::sin(angle), std::cos(angle), 0.0, 0.0, 0.0,
        is_down ? -1.0 : 1.0;
    Points plain = both_layers(), turned = plain;
    for (Vec3& x : turned) x = turn * x;
    apply(zigzag(), GAP, plain);
    apply(f, GAP, turned);
    for (std::size_t n = 0; n < plain.size(); ++n)
        CHECK((turn * plain[n] - turned[n]).norm() < 1e-10);
}

TEST_CASE("bands grow with the pack, and a pleat that is too narrow is refused", "[fold]") {
    Accordion f = zigzag();
    f.bands.clear();
    const Points x = both_layers();
    choose_bands(f, x, GAP, 5.0);
    REQUIRE(f.lines.size() == 3);
    for (const double h : f.bands) CHECK(h == 5.0);
    f.lines = {20.0, 60.0, 500.0};
    choose_bands(f, x, GAP, 5.0);
    CHECK(f.lines.size() == 2);  // the cloth ends before the third line
    f.lines = {20.0, 22.0};
    CHECK_THROWS_AS(choose_bands(f, x, GAP, 5.0), InputError);
    f.lines = {200.0};
    CHECK_THROWS_WITH(choose_bands(f, x, GAP, 5.0),
                      Catch::Contains("expected between -50 and 130"));
}
