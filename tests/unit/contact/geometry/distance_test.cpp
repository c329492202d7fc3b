// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <random>
#include <string>

#include "contact/geometry/distance.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

Vec3 random_point(std::mt19937& random) {
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    return {place(random), place(random), place(random)};
}

constexpr Pair NODE{{0, 1, 2, 3}, false}, EDGES{{0, 1, 2, 3}, true};

}  // namespace

TEST_CASE("the foot on a triangle falls into each of the seven regions", "[contact]") {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const auto corners = [&](double x, double y) {  // that the foot depends on
        const Vec3 w = foot_on_triangle({x, y, 0.3}, a, b, c);
        CHECK(w.sum() == Approx(1.0));
        return (w[0] > 0.0 ? "a" : "") + std::string(w[1] > 0.0 ? "b" : "") +
               (w[2] > 0.0 ? "c" : "");
    };
    CHECK(corners(0.2, 0.2) == "abc");
    CHECK(corners(-1, -1) == "a");
    CHECK(corners(2, -0.5) == "b");
    CHECK(corners(-0.5, 2) == "c");
    CHECK(corners(0.5, -1) == "ab");
    CHECK(corners(1, 1) == "bc");
    CHECK(corners(-1, 0.5) == "ac");
}

TEST_CASE("nothing on a triangle is nearer than the foot", "[contact]") {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    for (int i = 0; i < 500; ++i) {
        Corners x;
        for (Vec3& p : x) p = random_point(random);
        if (i % 5 == 0) x[3] = 0.5 * (x[1] + x[2]);  // no area
        if (i % 7 == 0) x[2] = x[1];                 // an edge without length
        const Nearest found = nearest(NODE, x);
        REQUIRE(std::abs(found.weight[0] + found.weight[1] + found.weight[2] + found.weight[3]) <
                1e-14);
        const double distance = found.apart.norm();
        for (int n = 0; n < 40; ++n) {
            double s = part(random), t = part(random);
            if (s + t > 1.0) s = 1.0 - s, t = 1.0 - t;
            const Vec3 other = x[1] + s * (x[2] - x[1]) + t * (x[3] - x[1]);
            REQUIRE(distance <= (x[0] - other).norm() + 1e-12);
        }
    }
}

TEST_CASE("nothing on two edges is nearer than their feet, parallel or not", "[contact]") {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> part(0.0, 1.0);
    int inside = 0;
    for (int i = 0; i < 500; ++i) {
        Corners x;
        for (Vec3& p : x) p = random_point(random);
        if (i % 5 == 0) x[3] = x[2] + 0.7 * (x[1] - x[0]);                // parallel
        if (i % 7 == 0) x[3] = x[2] + 0.7 * (x[1] - x[0]) + 1e-9 * x[3];  // all but parallel
        if (i % 11 == 0) x[3] = x[2];                                     // no length
        const Nearest found = nearest(EDGES, x);
        inside += found.is_inside;
        for (int n = 0; n < 40; ++n) {
            const double s = part(random), t = part(random);
            const Vec3 apart = x[0] + s * (x[1] - x[0]) - x[2] - t * (x[3] - x[2]);
            REQUIRE(found.apart.norm() <= apart.norm() + 1e-8);
        }
    }
    CHECK(inside > 50);
    CHECK(inside < 450);
}

TEST_CASE("the vector between nearest places is that of the weights", "[contact]") {
    std::mt19937 random(3);
    for (int i = 0; i < 200; ++i) {
        Corners x;
        for (Vec3& p : x) p = random_point(random);
        for (const Pair& pair : {NODE, EDGES}) {
            const Nearest found = nearest(pair, x);
            Vec3 sum = Vec3::Zero();
            for (int k = 0; k < 4; ++k) sum += found.weight[k] * x[k];
            REQUIRE((sum - found.apart).norm() < 1e-13);
        }
    }
}

TEST_CASE("along no direction is a pair farther apart than it is, along its own exactly so",
          "[contact]") {
    std::mt19937 random(17);
    const Pair pair = GENERATE(NODE, EDGES);
    for (int i = 0; i < 3000; ++i) {
        Points x;
        Corners now, v, late;
        for (int k = 0; k < 4; ++k) {
            x.push_back(now[k] = random_point(random));
            v[k] = random_point(random);
            late[k] = now[k] + v[k];
        }
        const double gap = nearest(pair, x).apart.norm();
        const Vec3 own = nearest(pair, x).apart / gap;
        CHECK(separation(pair, own, now) == Approx(gap).margin(1e-9));
        CHECK(separation(pair, random_point(random).normalized(), now) <= gap + 1e-12);
        // what take_up() goes by: bounds of the gap at the end of a step
        const double later = nearest(pair, {late.begin(), late.end()}).apart.norm();
        CHECK(separation(pair, own, late) <= later + 1e-12);
        CHECK(gap - greatest_approach(pair, v) <= later + 1e-12);
    }
}
