// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>

#include "tests/support/scenes/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::SpringCloth;

namespace {

constexpr std::size_t PLATE = 49;  ///< nodes of a held sheet

/// A small free sheet between two held ones, 4 mm apart.
SpringCloth sandwich() {
    support::Sheet all = support::square_sheet(6, 0.06);
    all.append(support::square_sheet(6, 0.06), {0, 0, 4e-3});
    all.append(support::square_sheet(2, 0.02), {0.0203, 0.0207, 2e-3});
    SpringCloth cloth(all);
    for (std::size_t i = 0; i < 2 * PLATE; ++i) cloth.held[i] = 1;
    return cloth;
}

/// A small sheet on a long held one.
SpringCloth sheet_on_slope() {
    support::Sheet all = support::square_sheet(12, 0.12);
    all.append(support::square_sheet(2, 0.02), {0.0113, 0.0507, 0.999 * SpringCloth::THICKNESS});
    SpringCloth cloth(all);
    for (std::size_t i = 0; i < 169; ++i) cloth.held[i] = 1;
    return cloth;
}

}  // namespace

TEST_CASE("frictionless bouncing without damping never gains energy", "[contact]") {
    SpringCloth cloth = sandwich();
    const double speed = GENERATE(2.0, 5.0, 20.0);
    const double step_factor = GENERATE(1.0, 0.3);
    for (std::size_t i = 2 * PLATE; i < cloth.x.size(); ++i)
        cloth.v[i] = Vec3(0.1, 0.05, 1.0) * speed;
    ContactCard card;
    card.damping = 0.0;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    const double start = cloth.kinetic_energy();
    double most = 0.0, last = 1.0;
    int bounces = 0;
    support::run_cloth(cloth, contact, step_factor * cloth.stable_step(), 1500, {}, [&](int) {
        most = std::max(most, cloth.kinetic_energy());
        const double momentum = cloth.momentum().z();
        bounces += momentum * last < 0.0;
        last = momentum;
    });
    CHECK(bounces >= 1);
    CHECK(most <= 1.001 * start);
}

TEST_CASE("a sheet on a slope sticks below the friction angle and slides as it should above",
          "[contact]") {
    constexpr double MU = 0.3, GRAVITY = 2000.0;
    const double slope = GENERATE(0.2, 0.28, 0.4, 0.6);  // tangent of its angle
    SpringCloth cloth = sheet_on_slope();
    ContactCard card;
    card.friction_static = card.friction_dynamic = MU;
    SurfaceContact contact(cloth.setup(card, cloth.x));
    const double dt = cloth.stable_step();
    const int steps = 900;
    const Vec3 gravity = GRAVITY * Vec3(slope, 0.0, -1.0);
    Vec3 place = Vec3::Zero(), half_way = Vec3::Zero();
    const auto centre = [&] {
        Vec3 sum = Vec3::Zero();
        for (std::size_t i = 169; i < cloth.x.size(); ++i) sum += cloth.mass[i] * cloth.x[i];
        double mass = 0.0;
        for (std::size_t i = 169; i < cloth.x.size(); ++i) mass += cloth.mass[i];
        return Vec3(sum / mass);
    };
    const auto load = [&](double, SpringCloth& c) {
        for (std::size_t i = 169; i < c.x.size(); ++i) c.f[i] += c.mass[i] * gravity;
    };
    const Vec3 start = centre();
    support::run_cloth(cloth, contact, dt, steps, load, [&](int n) {
        if (n == steps / 2) half_way = centre() - start;
        if (n == steps) place = centre() - start;
    });
    const double time = 0.5 * steps * dt;
    const double acceleration = GRAVITY * (slope - MU);
    CAPTURE(place.x(), half_way.x());
    if (slope < MU) {
        CHECK(std::abs(place.x()) < 1e-6);
    } else {
        // second difference over the two halves; the way from rest is a quarter and the whole
        CHECK(place.x() - 2.0 * half_way.x() == Approx(acceleration * time * time).epsilon(0.01));
        CHECK(contact.friction_energy() > 0.0);
    }
}
