// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: cloth that meets cloth never crosses it, counted exactly; momentum and energy are kept.
#include <catch2/catch.hpp>

#include <random>

#include "solver/base/parallel.hpp"
#include "tests/support/scenes/flying_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::fly;
using support::Sheet;
using support::SpringCloth;
using support::stack;
using support::wavy_sheet;

TEST_CASE("two sheets that meet at 50 and 100 m/s never cross", "[contact]") {
    const double speed = GENERATE(50.0, 100.0);
    ContactCard card;
    card.damping = GENERATE(20.0, 0.0);
    SpringCloth cloth(stack(24, 2, 5e-3));
    for (std::size_t i = 0; i < cloth.x.size(); ++i)
        cloth.v[i].z() = (i < cloth.x.size() / 2 ? 0.5 : -0.5) * speed;
    fly(cloth, card, 1e-3);
}

TEST_CASE("a stack of six sheets that is struck never crosses", "[contact]") {
    const double speed = GENERATE(50.0, 100.0);
    SpringCloth cloth(stack(20, 6, 1.5e-3));
    for (std::size_t i = 0; i < cloth.x.size() / 6; ++i) cloth.v[i].z() = speed;
    ContactCard card;
    card.friction_static = card.friction_dynamic = 0.2;
    fly(cloth, card, 0.8e-3);
}

TEST_CASE("a sheet that meets another with its edge never crosses it", "[contact]") {
    const double speed = GENERATE(20.0, 50.0);
    Sheet both = wavy_sheet(24, 1);
    Sheet upright = wavy_sheet(16, 2);
    for (Vec3& x : upright.x) x = Vec3(0.31 * x.x(), x.z(), x.y());
    both.append(upright, Vec3(0.1, 0.151, 3e-3));
    SpringCloth cloth(both);
    for (std::size_t i = 625; i < cloth.x.size(); ++i) cloth.v[i] = Vec3(0.06, 0.02, -1.0) * speed;
    fly(cloth, {}, 1e-3, 0.5);
}

TEST_CASE("a needle that is shot at a sheet never gets through", "[contact]") {
    const double speed = GENERATE(20.0, 80.0);
    support::Sheet both = wavy_sheet(24, 1);
    const auto tip = static_cast<Index>(both.x.size());
    const Vec3 at = GENERATE(Vec3(0.151, 0.152, 2e-3),  // somewhere on a triangle
                             Vec3(0.15, 0.15, 2e-3));   // just above a node
    both.x.push_back(at);
    constexpr int SIDES = 7;
    for (int k = 0; k < SIDES; ++k) {
        const double angle = 2.0 * M_PI * k / SIDES;
        both.x.push_back(at + Vec3(2e-3 * std::cos(angle), 2e-3 * std::sin(angle), 0.04));
        both.triangles.push_back({tip, tip + 1 + k, tip + 1 + (k + 1) % SIDES});
    }
    SpringCloth cloth(both);
    for (std::size_t i = tip; i < cloth.x.size(); ++i) {
        cloth.mass[i] *= 300.0;  // as heavy as the sheet
        cloth.v[i] = Vec3(0.05, 0.02, -1.0) * speed;
    }
    fly(cloth, {}, 2e-3);
}

TEST_CASE("a sheet that flies through a closing gap between 40 layers never crosses them",
          "[contact]") {
    constexpr int LAYERS = 40;
    constexpr Index N = 6;
    constexpr double PITCH = 1.2e-3, GAP = 10e-3;
    support::Sheet all;
    for (int k = 0; k < LAYERS; ++k)
        all.append(wavy_sheet(N, k),
                   {0.002 * (k % 3), 0.001 * (k % 5), PITCH * k + (k < LAYERS / 2 ? 0.0 : GAP)});
    const std::size_t layers = all.x.size();
    all.append(wavy_sheet(N, LAYERS), {-0.1, 0.01, PITCH * (LAYERS / 2 - 1) + GAP / 2 + PITCH / 2});
    SpringCloth cloth(all);
    for (std::size_t i = 0; i < layers; ++i)
        cloth.v[i].z() = i < layers / 2 ? 50.0 : -50.0;  // it closes within 100 us
    for (std::size_t i = layers; i < cloth.x.size(); ++i) cloth.v[i].x() = 100.0;
    contact::ContactCard card;
    card.friction_static = card.friction_dynamic = 0.2;
    fly(cloth, card, 0.4e-3, 0.5);
}

TEST_CASE("a sheet that is crumpled into a ball never crosses itself", "[contact]") {
    SpringCloth cloth(wavy_sheet(30, 3));
    std::mt19937 random(5);
    std::normal_distribution<double> noise(0.0, 5.0);
    for (std::size_t i = 0; i < cloth.x.size(); ++i)
        cloth.v[i] = -200.0 * (cloth.x[i] - Vec3(0.15, 0.15, 0)) +
                     Vec3(noise(random), noise(random), noise(random));
    const auto gather = [](double, SpringCloth& c) {  // and goes on being drawn together
        for (std::size_t i = 0; i < c.x.size(); ++i)
            c.f[i] -= 2e5 * c.mass[i] * (c.x[i] - Vec3(0.15, 0.15, 0));
    };
    fly(cloth, {}, 5e-3, 1.0, gather);
}

TEST_CASE("the panels of a flat bag part under a noisy pressure and never cross", "[contact]") {
    const double gap = GENERATE(1e-3, 1e-4);  // wider and narrower than the contact thickness
    SpringCloth cloth(support::two_panels(24, 0.3, gap, true));
    std::mt19937 random(7);
    std::normal_distribution<double> noise(1.0, 4.0);
    const auto inflate = [&](double t, SpringCloth& c) {
        const double pressure = 30e3 * std::min(1.0, t / 1e-3);
        for (const Triangle& triangle : c.triangles) {
            const Vec3 push = pressure * noise(random) / 3.0 *
                              vector_area(c.x[triangle[0]], c.x[triangle[1]], c.x[triangle[2]]);
            for (const Index node : triangle) c.f[node] += push;
        }
    };
    fly(cloth, {}, 5e-3, 1.0, inflate);
    double highest = 0.0;
    for (const Vec3& x : cloth.x) highest = std::max(highest, x.z());
    CHECK(highest > 0.04);
}

TEST_CASE("contact gives the same bits on one and two threads", "[contact]") {
    const auto run = [](int threads) {
        parallel::set_threads(threads);
        SpringCloth cloth(stack(20, 4, 1e-3));
        for (std::size_t i = 0; i < cloth.x.size() / 4; ++i) cloth.v[i] = Vec3(5.0, 2.0, 60.0);
        ContactCard card;
        card.friction_static = card.friction_dynamic = 0.2;
        SurfaceContact contact(cloth.setup(card, cloth.x));
        support::run_cloth(cloth, contact, cloth.stable_step(), 60, {}, [](int) {});
        return cloth;
    };
    const int before = parallel::threads();
    const SpringCloth one = run(1), two = run(2);
    parallel::set_threads(before);
    CHECK(one.x == two.x);
    CHECK(one.v == two.v);
}
