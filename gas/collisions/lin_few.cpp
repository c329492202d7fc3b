// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/lin_few.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "gas/collisions/group_spin.hpp"
#include "gas/collisions/relax.hpp"

namespace corpuscle::gas {

namespace {

constexpr double NO_HEAT = 1e-18;  ///< of the energy of all motion: less is rounding

/// Twice: where all lie nearly on a line, what rounding left of a spin about it weighs.
Mat3 take_out(const GroupSpin& spin, CellSample& sample) {
    const Mat3 G = spin.take_out(sample);
    return G + spin.take_out(sample);
}

}  // namespace

Mat3 random_rotation(Random& draw) {
    const double u = draw.uniform();
    const double a = 2.0 * std::numbers::pi * draw.uniform();
    const double b = 2.0 * std::numbers::pi * draw.uniform();
    const double r = std::sqrt(1.0 - u), s = std::sqrt(u);
    return Eigen::Quaterniond(s * std::cos(b), r * std::sin(a), r * std::cos(a), s * std::sin(b))
        .toRotationMatrix();
}

bool leave_unrelaxed(CellSample& sample) {
    sample.heat_internal();
    return false;
}

bool collide_few(const CollisionStep& step, CellSample& sample, Random& draw) {
    const double E_all = sample.translational();
    const double energy = E_all + sample.internal() + sample.heat;
    const GroupSpin spin(sample);
    const Mat3 G = take_out(spin, sample);
    const double E_0 = sample.translational();
    const double freedom = 3.0 * (static_cast<double>(sample.size()) - 1.0) - spin.freedom();
    if (freedom < 1.0 || E_0 <= NO_HEAT * E_all) {
        sample.add_gradient(G);
        sample.heat_internal();
        return true;
    }
    const std::optional<double> E_1 =
        share(energy - (E_all - E_0), freedom, step.mixture, Fluctuation::IN_GAS, sample, draw);
    if (!E_1) {
        sample.add_gradient(G);
        return leave_unrelaxed(sample);
    }
    if (sample.size() == 2) {
        sample.scale(-1.0);  // all that a line leaves
    } else {
        sample.add_gradient(spin.thermal(2.0 * E_0 / freedom, draw));
        if (sample.is_mixed()) sample.collide_unlike(draw);
        sample.transform(random_rotation(draw));
        take_out(spin, sample);
    }
    sample.scale(std::sqrt(*E_1 / sample.translational()));
    sample.add_gradient(G);
    return true;
}

}  // namespace corpuscle::gas
