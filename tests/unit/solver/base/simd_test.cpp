// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/base/simd.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <random>

using namespace corpuscle;

namespace {

constexpr double NONE = std::numeric_limits<double>::quiet_NaN();

/// Numbers of all sizes and both signs.
template <class Pack>
Pack some(std::mt19937& draw, int lanes) {
    Pack out{};
    std::uniform_real_distribution<double> size(-12.0, 12.0);
    for (int l = 0; l < lanes; ++l)
        out[l] = std::pow(10.0, size(draw)) * (draw() % 2 == 0 ? 1 : -1);
    return out;
}

}  // namespace

TEST_CASE("each lane gets what one number alone would", "[base][simd]") {
    std::mt19937 draw(5);
    for (int i = 0; i < 1000; ++i) {
        const Four a = some<Four>(draw, FOUR), root = roots_of(a * a), size = magnitude_of(a),
                   share = share_of(a);
        const Eight b = some<Eight>(draw, EIGHT), c = some<Eight>(draw, EIGHT),
                    low = least_of(b, c), high = greatest_of(b, c), part = share_of(b);
        for (int l = 0; l < FOUR; ++l) {
            CHECK(root[l] == std::sqrt(a[l] * a[l]));
            CHECK(size[l] == std::abs(a[l]));
            CHECK(share[l] == std::min(std::max(a[l], 0.0), 1.0));
        }
        for (int l = 0; l < EIGHT; ++l) {
            CHECK(low[l] == std::min(b[l], c[l]));
            CHECK(high[l] == std::max(b[l], c[l]));
            CHECK(part[l] == std::min(std::max(b[l], 0.0F), 1.0F));
        }
        float least = b[0];
        for (int l = 1; l < EIGHT; ++l) least = std::min(least, static_cast<float>(b[l]));
        CHECK(least_lane(b) == least);
    }
    CHECK(share_of(all_four(NONE))[2] == 0.0);
    CHECK(share_of(all_eight(static_cast<float>(NONE)))[7] == 0.0F);
}

TEST_CASE("bits name lanes, and lanes bits", "[base][simd]") {
    for (unsigned bits = 0; bits < 256; ++bits) {
        CHECK(bits_of(lanes_of(bits)) == bits);
        FourBits four{};
        for (int l = 0; l < FOUR; ++l) four[l] = (bits >> l & 1U) != 0 ? -1 : 0;
        CHECK(bits_of(four) == bits % 16);
    }
}

TEST_CASE("four points in memory become columns, and shuffles pick", "[base][simd]") {
    double points[12];
    for (int i = 0; i < 12; ++i) points[i] = i;
    const FourPoints at = columns(load_four(points), load_four(points + 4), load_four(points + 8));
    for (int p = 0; p < FOUR; ++p)
        for (int k = 0; k < 3; ++k) CHECK(at[k][p] == 3 * p + k);
    const Four picked = shuffled(at[0], FourBits{3, 3, 0, 1});
    CHECK(picked[0] == 9.0);
    CHECK(picked[1] == 9.0);
    CHECK(picked[2] == 0.0);
    CHECK(picked[3] == 3.0);
}
