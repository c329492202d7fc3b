// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fcl/narrowphase/distance.h>
#include <catch2/catch.hpp>

#include <random>

#include "contact/rigid_walls/wall_shape.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;

namespace {

struct Case {
    WallShape shape;
    fcl::CollisionObjectd twin;
};

/// The same body for us and for FCL.
Case make(int kind) {
    const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Vec3 place(0.2, -0.1, 0.3);
    const auto object = [&](auto geometry) {
        return fcl::CollisionObjectd(std::move(geometry), turn, place);
    };
    if (kind == 0) return {Ball{place, 0.4}, object(std::make_shared<fcl::Sphered>(0.4))};
    if (kind == 1)
        return {Rod{place - 0.5 * turn.col(2), turn.col(2), 0.3, 0.0, 1.0},
                object(std::make_shared<fcl::Cylinderd>(0.3, 1.0))};
    Brick block;
    block.axes = turn;
    block.corner = place;
    block.low = -Vec3(0.2, 0.3, 0.4);
    block.high = -block.low;
    return {block, object(std::make_shared<fcl::Boxd>(0.4, 0.6, 0.8))};
}

}  // namespace

TEST_CASE("gaps are those that FCL finds", "[contact]") {
    const Case c = make(GENERATE(0, 1, 2));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(-1.5, 1.5);
    constexpr double BEAD = 1e-3;  // FCL's point
    int outside = 0;
    for (int n = 0; n < 300; ++n) {
        const Vec3 at(u(random), u(random), u(random));
        const Nearby near = nearest(c.shape, at);
        if (near.gap < 2.0 * BEAD) continue;
        ++outside;
        fcl::DistanceRequestd request;
        fcl::DistanceResultd result;
        const fcl::CollisionObjectd bead(std::make_shared<fcl::Sphered>(BEAD), Mat3::Identity(),
                                         at);
        fcl::distance(&c.twin, &bead, request, result);
        CHECK(near.gap == Approx(result.min_distance + BEAD).margin(1e-5));
    }
    CHECK(outside > 100);
}

TEST_CASE("gap and normal span a plane that touches the shape and has all of it behind it",
          "[contact]") {
    const Case c = make(GENERATE(0, 1, 2));
    std::mt19937 random(4);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    Points inside, probes;
    while (inside.size() < 300) {
        const Vec3 at(u(random), u(random), u(random));
        probes.push_back(at);
        if (nearest(c.shape, at).gap < 0.0) inside.push_back(at);
    }
    for (const Vec3& at : probes) {
        const Nearby near = nearest(c.shape, at);
        const Vec3 foot = at - near.gap * near.normal;
        REQUIRE(near.normal.norm() == Approx(1.0));
        REQUIRE(std::abs(nearest(c.shape, foot).gap) < 1e-12);
        for (const Vec3& in : inside) REQUIRE(near.normal.dot(in - foot) < 1e-12);
    }
}

TEST_CASE("the entry of a way is where walking along it first gets in", "[contact]") {
    const Case c = make(GENERATE(0, 1, 2));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(-1.2, 1.2);
    constexpr int STEPS = 4000;
    int entries = 0;
    for (int n = 0; n < 200; ++n) {
        const Vec3 from(u(random), u(random), u(random)), to(u(random), u(random), u(random));
        if (nearest(c.shape, from).gap <= 0.0) continue;
        int first = 0;
        while (first <= STEPS && nearest(c.shape, from + first * (to - from) / STEPS).gap >= 0.0)
            ++first;
        const auto in = entry(c.shape, from, to);
        if (in && first > STEPS) {  // too short a visit for the walker
            const Vec3 at = from + in->share * (to - from);
            CHECK(std::abs(nearest(c.shape, at).gap) < 1e-9);
            continue;
        }
        REQUIRE(in.has_value() == (first <= STEPS));
        if (!in) continue;
        ++entries;
        CHECK(in->share == Approx(static_cast<double>(first) / STEPS).margin(1.01 / STEPS));
        const Vec3 at = from + in->share * (to - from);
        const Vec3 out = at + 1e-6 * in->normal, deep = at - 1e-6 * in->normal;
        CHECK(nearest(c.shape, out).gap == Approx(1e-6).epsilon(1e-3));
        CHECK(nearest(c.shape, deep).gap < 0.0);
        CHECK(in->normal.dot(to - from) < 0.0);
    }
    CHECK(entries > 20);
}

TEST_CASE("a way along a surface, away from it, or that ends before it, does not lead in",
          "[contact]") {
    Brick block;
    block.low = Vec3(0, 0, -1);
    block.high = Vec3(1, 1, 0);
    CHECK_FALSE(entry(block, {0.5, 0.5, 0.0}, {0.9, 0.5, 0.0}));
    CHECK_FALSE(entry(block, {-1.0, 0.5, 0.0}, {2.0, 0.5, 0.0}));
    CHECK_FALSE(entry(block, {0.5, 0.5, 1.0}, {0.5, 0.5, 2.0}));
    CHECK_FALSE(entry(block, {0.5, 0.5, 1.0}, {0.5, 0.5, 0.1}));
    CHECK(entry(block, {0.5, 0.5, 1.0}, {0.5, 0.5, -0.5})->share == Approx(2.0 / 3.0));
    CHECK_FALSE(entry(Ball{Vec3::Zero(), 1.0}, {1.0, 0.0, 0.0}, {1.0, 3.0, 0.0}));
    const Rod endless{Vec3::Zero(), Vec3::UnitZ(), 1.0};
    CHECK(entry(endless, {3.0, 0.0, 50.0}, {0.0, 0.0, -50.0})->share == Approx(2.0 / 3.0));
    CHECK_FALSE(entry(endless, {1.0, 0.0, 50.0}, {1.0, 0.0, -50.0}));
    CHECK(nearest(endless, {3.0, 0.0, -1e6}).gap == Approx(2.0));
}
