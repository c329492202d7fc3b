// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <catch2/catch.hpp>

#include <random>

#include "contact/broad_phase/intersections.hpp"
#include "solver/base/parallel.hpp"
#include "tests/support/scenes/spring_cloth.hpp"

/// Sheets of cloth that are thrown at each other, and what must hold while they are.
namespace corpuscle::support {

/// A sheet of 0.3 m, uneven so that nothing is aligned.
inline Sheet wavy_sheet(Index n, unsigned seed) {
    Sheet sheet = square_sheet(n, 0.3);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> shake(-1.0, 1.0);
    const double edge = 0.3 / n;
    for (Vec3& x : sheet.x)
        x += Vec3(0.1 * edge * shake(random), 0.1 * edge * shake(random), 2e-4 * shake(random));
    return sheet;
}

inline Sheet stack(Index n, int sheets, double pitch) {
    Sheet all;
    for (int k = 0; k < sheets; ++k)
        all.append(wavy_sheet(n, k), Vec3(0.003 * k, 0.002 * k, pitch * k));
    return all;
}

using Load = std::function<void(double, SpringCloth&)>;

/// Runs with steps of `step_factor` times the stable one. Requires that nothing crosses in every
/// fifth state, and that momentum and energy are kept: what contact has taken and what it says that
/// it has are the same.
inline void fly(SpringCloth& cloth, const contact::ContactCard& card, double time,
                double step_factor = 1.0, const Load& load = {}) {
    parallel::set_threads(
        1);  // scenes so small, in steps so short, only make threads wait for each other
    contact::SurfaceContact contact(cloth.setup(card, cloth.x));
    const contact::Patches patches = contact::make_patches(cloth.x, cloth.triangles);
    const double dt = step_factor * cloth.stable_step();
    const Vec3 momentum = cloth.momentum();
    const double energy = cloth.kinetic_energy();
    double scale = 0.0;
    const auto run = run_cloth(cloth, contact, dt, static_cast<int>(time / dt), load, [&](int n) {
        double size = 0.0;
        for (std::size_t i = 0; i < cloth.x.size(); ++i) size += cloth.mass[i] * cloth.v[i].norm();
        scale = std::max(scale, size);
        if (n % 5 == 0) REQUIRE(contact::crossings(cloth.triangles, patches, cloth.x).empty());
    });
    CHECK(contact.counts().unstopped == 0);
    CHECK(contact.counts().least_gap > 0.0);
    CHECK(contact.counts().least_gap < 1.0);  // they did meet
    if (!load) CHECK((cloth.momentum() - momentum).norm() < 1e-12 * scale);

    // The springs' work is what leapfrog makes of it; near its stability limit that is not their
    // energy.
    const double end =
        cloth.kinetic_energy() - run.work_of_springs - run.work_of_loads + contact.energy();
    CHECK(std::abs(end - energy) < 1e-9 * (energy + std::abs(run.work_of_loads)));
    CHECK(contact.damping_energy() >= 0.0);  // no gain
}

}  // namespace corpuscle::support
