// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <catch2/catch.hpp>

#include <variant>

#include "tests/verification/contact/folded_meshes.hpp"

using namespace corpuscle;
using namespace corpuscle::fabric;
using namespace corpuscle::fabric::test;

namespace {

/// Greatest total energy (what loops have lost included) over that at the start.
double growth(Folded& folded, double factor, int steps) {
    Membranes membranes = folded.sheet.membranes();
    const std::vector<double> mass = lumped_mass(folded.sheet.setup());
    Points x = folded.x, v = folded.v, f(x.size());
    double start = NaN, most = 0.0, before = factor * membranes.stable_step().dt;
    for (int i = 0; i < steps; ++i) {
        std::fill(f.begin(), f.end(), Vec3::Zero());
        if (membranes.add_force(x, v, f) >= 0) return INF;
        const double dt = factor * membranes.stable_step().dt;
        const double span = 0.5 * (before + dt);  // half the last step, half this one
        before = dt;
        double energy = membranes.strain_energy() + membranes.lost_energy();
        for (std::size_t n = 0; n < x.size(); ++n) {
            const Vec3 kicked = v[n] + span / mass[n] * f[n];
            energy += 0.5 * mass[n] * (0.5 * (v[n] + kicked)).squaredNorm();
            v[n] = kicked;
            x[n] += dt * v[n];
        }
        if (i == 0) start = energy;
        if (!(energy < 1e6 * start)) return INF;
        most = std::max(most, energy);
    }
    return most / start;
}

/// Of a mode at 0.9 of its limit the energy at whole steps may reach 1/(1 - 0.9²) of its start.
constexpr double BEATS = 5.3;

void check(unsigned first, unsigned last, int steps, double damping = 0.0) {
    double worst = 0.0, sum = 0.0;
    unsigned who = 0;
    for (unsigned seed = first; seed <= last; ++seed) {
        Folded folded(seed);
        for (Material& material : folded.sheet.materials)
            if (auto* card = std::get_if<FabricCard>(&material.card)) card->damping = damping;
        const double g = growth(folded, 0.9, steps);
        sum += g;
        if (!(g <= worst)) {
            worst = g;
            who = seed;
        }
    }
    fmt::print(
        "Folded meshes {} to {}, DAMP {}, {} steps at 0.9: energy at most {:.3f} of the start "
        "(mesh {}), {:.3f} on average\n",
        first, last, damping, steps, worst, who, sum / (last - first + 1));
    CHECK(worst < 0.5 * BEATS);
}

}  // namespace

TEST_CASE("folded and distorted meshes keep their energy for 10 000 steps at 0.9") {
    check(1, 250, 10000);
}

TEST_CASE("folded and distorted meshes that are hardly damped lose energy at 0.9") {
    check(1, 250, 10000, 0.01);
}

TEST_CASE("a thousand folded and distorted meshes keep their energy for 10 000 steps", "[.long]") {
    check(1, 1000, 10000);
}
