// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/collide.hpp"
#include "gas/swarm.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

/// Gathers each group, has `collide_one(swarm, draw, rows)` change its c and e, and scatters it
/// back. What is drawn depends on the step and the group's number alone. `collide_one` returns
/// false when a group could not be relaxed.
template <class CollideOne>
CollisionReport for_each_group(const CollisionStep& step, Particles& particles,
                               CollideOne&& collide_one) {
    constexpr std::size_t GROUPS_A_CHUNK = 64;
    CollisionReport report;
    report.unrelaxed = parallel::sum(
        step.groups.size(), std::size_t{0},
        [&](std::size_t g) -> std::size_t {
            thread_local Swarm swarm;
            const auto rows = step.groups[g];
            if (g + 1 < step.groups.size()) prefetch(step.groups[g + 1], particles);
            swarm.gather(rows, step.mixture, particles);
            Random draw(step.seed, Stream::COLLISION, step.step, g);
            const bool is_relaxed = collide_one(swarm, draw, rows);
            swarm.scatter(rows, particles);
            return is_relaxed ? 0 : 1;
        },
        GROUPS_A_CHUNK);
    return report;
}

}  // namespace corpuscle::gas
