// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Claim: cloth that meets cloth never crosses it, counted exactly; momentum and energy are kept.
#include <catch2/catch.hpp>

#include <cstdlib>
#include <iostream>
#include <random>

#include "contact/intersections.hpp"
#include "tests/support/spring_cloth.hpp"

using namespace corpuscle;
using namespace corpuscle::contact;
using support::Sheet;
using support::SpringCloth;

namespace {

/// A sheet of 0.3 m with some waviness, so that nothing is aligned.
Sheet wavy_sheet(Index n, unsigned seed) {
    Sheet sheet = support::square_sheet(n, 0.3);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shake(-1.0, 1.0);
    const double edge = 0.3 / n;
    for (Vec3& x : sheet.x) x += Vec3(0.1 * edge, 0.1 * edge, 2e-4).cwiseProduct(Vec3(shake(random), shake(random), shake(random)));
    return sheet;
}

Sheet stack(Index n, int sheets, double pitch) {
    Sheet all;
    for (int k = 0; k < sheets; ++k)
        all.append(wavy_sheet(n, k), Vec3(0.003 * k, 0.002 * k, pitch * k));
    return all;
}

struct Outcome {
    std::size_t most_crossings = 0;
    double energy_error = 0.0, momentum_error = 0.0;
};

/// Runs and compares: crossings at each `every`-th state, energy and momentum between start and end.
Outcome fly(SpringCloth& cloth, const SelfContactCard& card, double time, double step_factor = 1.0) {
    SelfContact contact(cloth.setup(card, cloth.x));
    const Patches patches = make_patches(cloth.x, cloth.triangles);
    const double dt = step_factor * cloth.stable_step();
    const Vec3 momentum = cloth.momentum();
    const double energy = cloth.kinetic_energy();
    double scale = 0.0;
    for (std::size_t i = 0; i < cloth.x.size(); ++i) scale += cloth.mass[i] * cloth.v[i].norm();
    Outcome out;
    const int steps = static_cast<int>(time / dt);
    const auto run = support::run_cloth(cloth, contact, dt, steps, {}, [&](int n) {
        if (n % 10 == 0)
            out.most_crossings = std::max(out.most_crossings, crossings(cloth.triangles, patches, cloth.x).size());
    });
    const double end = cloth.kinetic_energy() - run.work_of_springs - run.work_of_contact +
                       contact.friction_energy() + contact.damping_energy();
    out.energy_error = std::abs(end - energy) / energy;
    out.momentum_error = (cloth.momentum() - momentum).norm() / scale;
    const auto& c = contact.counts();
    if (std::getenv("SHOW"))
    std::cout << "dt " << dt << " steps " << steps << " builds " << c.builds << " candidates " << c.candidates
              << " near " << c.near << " touching " << c.touching << " least gap " << c.least_gap << " E0 " << energy
              << " KE " << cloth.kinetic_energy() << " SE " << cloth.strain_energy() << " contact work " << run.work_of_contact
              << " fr " << contact.friction_energy() << " damp " << contact.damping_energy() << " crossings "
              << out.most_crossings << " dE " << out.energy_error << " dP " << out.momentum_error << "\n";
    return out;
}

}  // namespace

TEST_CASE("two sheets that meet at 50 and 100 m/s never cross", "[contact]") {
    const double speed = GENERATE(50.0, 100.0);
    const double damping = GENERATE(20.0, 0.0);
    SpringCloth cloth(stack(24, 2, 5e-3));
    for (std::size_t i = 0; i < cloth.x.size(); ++i) cloth.v[i].z() = (i < cloth.x.size() / 2 ? 0.5 : -0.5) * speed;
    SelfContactCard card;
    card.damping = damping;
    const Outcome out = fly(cloth, card, 1e-3);
    CHECK(out.most_crossings == 0);
    CHECK(out.energy_error < 1e-9);
    CHECK(out.momentum_error < 1e-12);
}

TEST_CASE("a stack of six sheets that is struck never crosses", "[contact]") {
    const double speed = GENERATE(50.0, 100.0);
    SpringCloth cloth(stack(24, 6, 1.5e-3));
    for (std::size_t i = 0; i < cloth.x.size() / 6; ++i) cloth.v[i].z() = speed;
    const Outcome out = fly(cloth, {}, 1e-3, 0.5);
    CHECK(out.most_crossings == 0);
    CHECK(out.energy_error < 1e-9);
    CHECK(out.momentum_error < 1e-12);
}

TEST_CASE("a sheet that meets the edge of another never crosses it", "[contact]") {
    Sheet both = wavy_sheet(24, 1);
    Sheet upright = wavy_sheet(16, 2);
    for (Vec3& x : upright.x) x = Vec3(0.31 * x.x(), x.z(), x.y());
    both.append(upright, Vec3(0.1, 0.151, 5e-3));
    const double speed = GENERATE(10.0, 20.0, 50.0);
    SpringCloth cloth(both);
    for (std::size_t i = 625; i < cloth.x.size(); ++i) cloth.v[i] = Vec3(0.06, 0.02, -1.0) * speed;
    const Outcome out = fly(cloth, {}, 1e-3, 0.5);
    CHECK(out.most_crossings == 0);
    CHECK(out.energy_error < 1e-9);
    CHECK(out.momentum_error < 1e-12);
}
