// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/curve.hpp"

#include <catch2/catch.hpp>

#include "solver/base/vec.hpp"

using namespace corpuscle;

TEST_CASE("a curve interpolates and keeps its end values", "[base][curve]") {
    const Curve curve{1, {0.0, 1.0, 3.0}, {2.0, 4.0, 0.0}};
    CHECK(curve(-1.0) == 2.0);
    CHECK(curve(0.5) == 3.0);
    CHECK(curve(2.0) == 2.0);
    CHECK(curve(9.0) == 0.0);
}

TEST_CASE("a curve that begins with a jump has the value after it there", "[base][curve]") {
    const Curve curve{1, {0.0, 0.0, 2.0}, {0.0, 5.0, 5.0}};
    CHECK(curve(-1.0) == 0.0);
    CHECK(curve(0.0) == 5.0);
    CHECK(curve.mean(0.0, 1.0) == 5.0);
    CHECK(curve.mean(-1.0, 1.0) == 2.5);
    CHECK(curve.integral_to(1.0) == 5.0);
    const Curve point{1, {1.0, 1.0}, {2.0, 3.0}};
    CHECK(point(0.5) == 2.0);
    CHECK(point(1.0) == 3.0);
    CHECK(point(1.5) == 3.0);
}

TEST_CASE("a curve that reaches the end goes on along its last segment, one that does not stays",
          "[base][curve]") {
    const Curve curve{1, {0.0, 1.0, 3.0}, {2.0, 4.0, 0.0}};
    const Curve on = curve.continued_beyond(GENERATE(3.0, 3.0 * (1.0 + 1e-12), 2.0));
    for (const double at : {-1.0, 0.0, 0.3, 1.0, 2.9, 3.0}) CHECK(on(at) == curve(at));
    CHECK(on(3.5) == Approx(-1.0));
    CHECK(on.mean(2.0, 4.0) == Approx(0.0).margin(1e-12));
    CHECK(curve.continued_beyond(3.01)(4.0) == 0.0);
    CHECK(curve.continued_beyond(INF)(4.0) == 0.0);
    const Curve jump{1, {0.0, 1.0, 1.0}, {2.0, 4.0, 0.0}}, point{1, {1.0}, {2.0}};
    CHECK(jump.continued_beyond(1.0)(1.5) == 0.0);
    CHECK(point.continued_beyond(1.0)(1.5) == 2.0);
}

TEST_CASE("integral and mean of a curve agree with a fine sum", "[base][curve]") {
    // with a jump at 1
    const Curve curve{1, {0.0, 1.0, 1.0, 3.0}, {2.0, 4.0, -1.0, 0.5}};
    const auto sum = [&](double from, double to) {
        double total = 0.0;
        const int n = 200000;
        for (int i = 0; i < n; ++i)
            total += curve(from + (to - from) * (i + 0.5) / n) * (to - from) / n;
        return total;
    };
    for (const auto& [from, to] : {std::pair{0.0, 3.0},
                                   {0.2, 0.7},
                                   {0.5, 1.0},
                                   {1.0, 2.0},
                                   {0.3, 2.9},
                                   {2.5, 5.0},
                                   {-1.0, 0.5}})
        CHECK(curve.mean(from, to) * (to - from) == Approx(sum(from, to)).epsilon(1e-4));
    CHECK(curve.integral_to(0.5) == Approx(1.25));
    CHECK(curve.integral_to(3.0) == Approx(sum(0.0, 3.0)).epsilon(1e-4));
    CHECK(curve.integral_to(10.0) == curve.integral_to(3.0));
}
