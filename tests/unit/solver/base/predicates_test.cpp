// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/predicates.hpp"

#include <catch2/catch.hpp>

#include "solver/base/random.hpp"

using namespace corpuscle;

TEST_CASE("the determinant's sign is exact on the verge of zero", "[base][predicates]") {
    // c is a combination of a and b but for its last bit: rounding alone cannot tell the sides
    // apart.
    Random draw(1, Stream::INITIAL, 0, 0);
    int unsure = 0;
    for (int i = 0; i < 2000; ++i) {
        const Vec3 a(draw.uniform(), draw.uniform(), draw.uniform());
        const Vec3 b(draw.uniform(), draw.uniform(), draw.uniform());
        const Vec3 c = 0.5 * a + 0.25 * b;
        const int sign = determinant(a, b, c).sign;
        CHECK(determinant(b, c, a).sign == sign);
        CHECK(determinant(c, a, b).sign == sign);
        CHECK(determinant(b, a, c).sign == -sign);
        CHECK(determinant(a, b, Vec3(c + 1e-12 * a.cross(b))).sign == 1);
        CHECK(determinant(a, b, Vec3(c - 1e-12 * a.cross(b))).sign == -1);
        const double value = determinant(a, b, c).value;
        unsure += value == 0.0 || (value > 0.0 ? 1 : -1) != sign;
    }
    CHECK(unsure > 0);  // the case is hard enough: rounding gave a wrong sign somewhere
    CHECK(determinant(Vec3(1, 2, 3), Vec3(2, 4, 6), Vec3(5, 1, 7)).sign == 0);
}
