// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include "gas/collisions/collide.hpp"
#include "gas/collisions/relax.hpp"
#include "solver/base/parallel.hpp"
#include "tests/unit/gas/collisions/collide_setup.hpp"
#include "tests/unit/gas/random_gas.hpp"

using namespace corpuscle;
using namespace corpuscle::gas;
using namespace collide_setup;

TEST_CASE("stress relaxes as hard spheres of the chosen mean free path make it", "[gas]") {
    // d(P - p I)/dt = -(p / eta) (P - p I), eta = 5 pi/32 rho c lambda, c = sqrt(8/pi) c_T [Chapman
    // & Enskog, first approximation]: the stress falls by e within a time of 0.783 lambda / c_T.
    const auto model = GENERATE(CollisionModel::NTC, CollisionModel::SPHERES);
    const double lambda = GENERATE(0.1, 0.2);
    const Mixture mixture = mixture_of({HELIUM});
    const auto stress = [&](const Particles& gas) {
        double x = 0.0, all = 0.0;
        for (const Vec3& v : gas.v) {
            x += v.x() * v.x();
            all += v.squaredNorm();
        }
        return x / all - 1.0 / 3.0;
    };
    Particles gas = random_gas(40000, BOX, mixture, {300});
    for (Vec3& v : gas.v) v.x() *= 1.2;
    const double before = stress(gas);
    double twice_energy = 0.0;
    for (const Vec3& v : gas.v) twice_energy += v.squaredNorm() / 40000;

    Collider collider(mixture.species(), mixture.moles_each(), 3, model, lambda);
    const double dt = 0.05 * lambda / std::sqrt(twice_energy / 3.0);
    for (std::uint64_t step = 0; step < 16; ++step) {
        collider.find_groups(CELLS, {}, gas);
        collider.collide(step, dt, 1.0, gas);
        drift_in_box(dt, BOX, gas);
    }
    // Noise 5 %. Spheres miss partners in the next cell: the fewer, the shorter the steps.
    CHECK(std::log(before / stress(gas)) == Approx(0.8 / 0.783).epsilon(0.15));
}
