// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include "gas/collisions/collide.hpp"
#include "gas/collisions/relax.hpp"
#include "solver/base/parallel.hpp"
#include "tests/unit/gas/random_gas.hpp"

namespace collide_setup {

using namespace corpuscle;
using namespace corpuscle::gas;

inline const Vec3 BOX(1.0, 1.0, 1.0);
inline const Grid CELLS = Grid::over(Vec3::Zero(), BOX - Vec3::Constant(1e-9), 0.2, 1000);

/// The test case runs once for each.
inline CollisionModel every_model() {
    return GENERATE(CollisionModel::PAIRS, CollisionModel::LIN, CollisionModel::NTC,
                    CollisionModel::SPHERES);
}

/// Time between collisions for models that ask: air at 300 K crosses a quarter of a cell.   [s]
inline const double DT = 0.25 * CELLS.edge / std::sqrt(GAS_CONSTANT * 300.0 / 0.028);

/// Collisions and free flight in a mirror box, 0.25 of a cell's edge between collisions.
class Box {
public:
    Box(const Mixture& mixture, CollisionModel model)
        : collider_(mixture.species(), mixture.moles_each(), 11, model) {}

    void run(int steps, double c_T, Particles& gas) {
        for (int i = 0; i < steps; ++i) {
            collider_.find_groups(CELLS, {}, gas);
            const double dt = 0.25 * CELLS.edge / c_T;
            collider_.collide(step_++, dt, 1.0, gas);
            drift_in_box(dt, BOX, gas);
        }
    }

private:
    Collider collider_;
    std::uint64_t step_ = 0;
};

/// Distance of the sample from the Maxwell-Boltzmann distribution of speeds (eq. 26), times
/// sqrt(n).
inline double kolmogorov_smirnov(std::vector<double> speed, double mass, double kT) {
    std::sort(speed.begin(), speed.end());
    const double n = static_cast<double>(speed.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < speed.size(); ++i) {
        const double s = speed[i] / std::sqrt(kT / mass);
        const double F = std::erf(s / std::numbers::sqrt2) -
                         std::sqrt(2.0 / std::numbers::pi) * s * std::exp(-0.5 * s * s);
        const double below = static_cast<double>(i) / n;
        worst = std::max({worst, std::abs(F - below), std::abs(F - below - 1.0 / n)});
    }
    return worst * std::sqrt(n);
}

}  // namespace collide_setup
