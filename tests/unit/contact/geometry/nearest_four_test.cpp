// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <random>

#include "contact/geometry/nearest_four.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

TEST_CASE("the nearest places of four pairs are those of each, degenerate or not", "[contact]") {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    const bool is_edges = GENERATE(false, true);
    int inside = 0, outside = 0;
    for (int i = 0; i < 2000; ++i) {
        Points x;
        std::array<Pair, FOUR> pairs;
        std::array<const Pair*, FOUR> four{};
        for (std::size_t l = 0; l < FOUR; ++l) {
            for (int k = 0; k < 4; ++k) x.emplace_back(place(random), place(random), place(random));
            const auto n = static_cast<Index>(4 * l);
            pairs[l] = {{n, n + 1, n + 2, n + 3}, is_edges};
            four[l] = &pairs[l];
            // parallel edges, a triangle without area; an edge without length; places that touch
            if (random() % 6 == 0) x[n + 3] = x[n + 2] + 0.5 * (x[n + 1] - x[n]);
            if (random() % 7 == 0) x[n + 3] = 0.5 * (x[n + 1] + x[n + 2]);
            if (random() % 8 == 0) x[n + 3] = x[n + 2];
            if (random() % 9 == 0) x[n + 2] = x[n];
        }
        const NearestFour found = nearest(four, x);
        for (std::size_t l = 0; l < FOUR; ++l) {
            const Nearest one = nearest(pairs[l], x), of_four = found[l];
            REQUIRE(of_four.is_inside == one.is_inside);
            REQUIRE((of_four.apart - one.apart).norm() < 1e-9);
            REQUIRE(std::abs(found.gap[l] - one.apart.norm()) < 1e-9);
            Vec3 by_weights = Vec3::Zero();
            for (int k = 0; k < 4; ++k) by_weights += of_four.weight[k] * x[pairs[l].node[k]];
            REQUIRE((by_weights - one.apart).norm() < 1e-9);
            ++(one.is_inside ? inside : outside);
        }
    }
    CHECK(inside > 200);
    CHECK((outside > 200 || !is_edges));
}
