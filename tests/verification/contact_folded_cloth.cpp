// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: cloth that meets cloth never crosses it, counted exactly; momentum and energy are kept.
#include <catch2/catch.hpp>

#include <random>

#include "contact/intersections.hpp"
#include "solver/base/parallel.hpp"
#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::Sheet;
using support::SpringCloth;

namespace {

/// A sheet of 0.3 m, uneven so that nothing is aligned.
Sheet wavy_sheet(Index n, unsigned seed) {
    Sheet sheet = support::square_sheet(n, 0.3);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shake(-1.0, 1.0);
    const double edge = 0.3 / n;
    for (Vec3& x : sheet.x)
        x += Vec3(0.1 * edge * shake(random), 0.1 * edge * shake(random), 2e-4 * shake(random));
    return sheet;
}

Sheet stack(Index n, int sheets, double pitch) {
    Sheet all;
    for (int k = 0; k < sheets; ++k)
        all.append(wavy_sheet(n, k), Vec3(0.003 * k, 0.002 * k, pitch * k));
    return all;
}

using Load = std::function<void(double, SpringCloth&)>;

/// Runs with steps of `step_factor` times the stable one. Requires that nothing crosses in every
/// fifth state, and that momentum and energy are kept: what contact has taken and what it says that
/// it has are the same.
void fly(SpringCloth& cloth, const ContactCard& card, double time, double step_factor = 1.0,
         const Load& load = {}) {
    parallel::set_threads(
        1);  // scenes so small, in steps so short, only make threads wait for each other
    SurfaceContact contact(cloth.setup(card, cloth.x));
    const Patches patches = make_patches(cloth.x, cloth.triangles);
    const double dt = step_factor * cloth.stable_step();
    const Vec3 momentum = cloth.momentum();
    const double energy = cloth.kinetic_energy();
    double scale = 0.0;
    const auto run =
        support::run_cloth(cloth, contact, dt, static_cast<int>(time / dt), load, [&](int n) {
            double size = 0.0;
            for (std::size_t i = 0; i < cloth.x.size(); ++i)
                size += cloth.mass[i] * cloth.v[i].norm();
            scale = std::max(scale, size);
            if (n % 5 == 0) REQUIRE(crossings(cloth.triangles, patches, cloth.x).empty());
        });
    CHECK(contact.counts().unstopped == 0);
    CHECK(contact.counts().least_gap > 0.0);
    CHECK(contact.counts().least_gap < 1.0);  // they did meet
    if (!load) CHECK((cloth.momentum() - momentum).norm() < 1e-12 * scale);

    // The springs' work is what leapfrog makes of it; near its stability limit that is not their
    // energy.
    const double end = cloth.kinetic_energy() - run.work_of_springs - run.work_of_loads -
                       run.work_of_contact + contact.friction_energy() + contact.damping_energy();
    CHECK(std::abs(end - energy) < 1e-9 * (energy + std::abs(run.work_of_loads)));
    CHECK(contact.damping_energy() - run.work_of_contact >= contact.stored_energy());  // no gain
}

}  // namespace

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
