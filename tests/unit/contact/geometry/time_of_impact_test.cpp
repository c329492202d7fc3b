// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include <random>

#include "contact/geometry/time_of_impact.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {
constexpr Pair NODE_PAIR{{0, 1, 2, 3}, false}, EDGE_PAIR{{0, 1, 2, 3}, true};
}

TEST_CASE("a node that flies through a triangle is caught before it gets there", "[contact]") {
    const Corners x{Vec3(0.2, 0.2, 1.0), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const auto time = [&](double fall) {
        return time_of_impact(NODE_PAIR, x,
                              {Vec3(0, 0, -fall), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}, 1.0);
    };
    CHECK(time(2.0) < 0.5);
    CHECK(time(2.0) > 0.4);
    CHECK(time(100.0) < 0.01);
    CHECK(time(0.8) == NO_IMPACT);
    CHECK(time(-100.0) == NO_IMPACT);
}

TEST_CASE("what moves together never meets", "[contact]") {
    const Corners x{Vec3(0.2, 0.2, 1e-6), Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    const Vec3 far(300.0, -200.0, 100.0);
    CHECK(time_of_impact(NODE_PAIR, x, {far, far, far, far}, 1.0) == NO_IMPACT);
    CHECK(time_of_impact(EDGE_PAIR, x, {far, far, far, far}, 1.0) == NO_IMPACT);
}

TEST_CASE("no pair comes nearer than promised before its time of impact", "[contact]") {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> place(-1.0, 1.0);
    const auto any = [&] { return Vec3(place(random), place(random), place(random)); };
    int impacts = 0;
    for (int i = 0; i < 3000; ++i) {
        Corners x, move;
        for (Vec3& p : x) p = any();
        for (Vec3& p : move) p = 1.5 * any();
        const Pair& pair = i % 2 == 0 ? NODE_PAIR : EDGE_PAIR;
        const double time = time_of_impact(pair, x, move, 0.1);
        impacts += time != NO_IMPACT;
        const double promised = 0.1 * std::min(0.1, nearest(pair, x).apart.norm());
        const double end = std::min(time, 1.0);
        for (int n = 1; n <= 50; ++n) {
            Corners there = x;
            for (int k = 0; k < 4; ++k) there[k] += 0.999 * end * n / 50 * move[k];
            // the last advance may eat up to nine tenths of what is left
            REQUIRE(nearest(pair, there).apart.norm() > 0.04 * promised);
        }
    }
    CHECK(impacts > 300);
    CHECK(impacts < 2700);
}
