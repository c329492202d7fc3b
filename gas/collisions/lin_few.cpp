// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/lin_few.hpp"

#include <cmath>
#include <numbers>
#include <optional>

#include "gas/collisions/group_spin.hpp"
#include "gas/collisions/lin.hpp"
#include "gas/collisions/relax.hpp"

namespace corpuscle::gas {

Mat3 random_rotation(Random& draw) {
    const double u = draw.uniform();
    const double a = 2.0 * std::numbers::pi * draw.uniform();
    const double b = 2.0 * std::numbers::pi * draw.uniform();
    const double r = std::sqrt(1.0 - u), s = std::sqrt(u);
    return Eigen::Quaterniond(s * std::cos(b), r * std::sin(a), r * std::cos(a), s * std::sin(b))
        .toRotationMatrix();
}

bool leave_unrelaxed(Swarm& swarm) {
    swarm.add_internal(swarm.heat);
    return false;
}

bool collide_few(const CollisionStep& step, Swarm& swarm, Random& draw) {
    const double E_all = swarm.translational();
    const double energy = E_all + swarm.internal() + swarm.heat;
    const GroupSpin spin(swarm);
    const Mat3 G = spin.take_out(swarm);
    const double E_0 = swarm.translational();
    const double freedom = 3.0 * (static_cast<double>(swarm.size()) - 1.0) - spin.freedom();
    if (freedom < 1.0 || E_0 <= lin::FLATTEST * lin::FLATTEST * E_all) {
        swarm.add_gradient(G);
        swarm.add_internal(swarm.heat);
        return true;
    }
    const std::optional<double> E_1 =
        share(energy - (E_all - E_0), freedom, step.mixture, swarm, draw);
    if (!E_1) {
        swarm.add_gradient(G);
        return leave_unrelaxed(swarm);
    }
    if (swarm.size() == 2) {
        swarm.scale(-1.0);  // all that a line leaves
    } else {
        swarm.add_gradient(spin.thermal(2.0 * E_0 / freedom, draw));
        if (swarm.is_mixed()) swarm.collide_unlike(draw);
        swarm.transform(random_rotation(draw));
        spin.take_out(swarm);
    }
    swarm.scale(std::sqrt(*E_1 / swarm.translational()));
    swarm.add_gradient(G);
    return true;
}

}  // namespace corpuscle::gas
