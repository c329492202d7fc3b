// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/collisions/cell_sample.hpp"
#include "gas/collisions/collide.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/random.hpp"

namespace corpuscle::gas {

/// Gathers a group, has `collide_one(sample, draw, rows)` change its c and e, and scatters it back.
/// What is drawn depends on the step and the group's number alone. `collide_one` returns false when
/// the group could not be relaxed.
template <class CollideOne>
CollisionReport collide_one_group(const CollisionStep& step, std::size_t group,
                                  Particles& particles, CollideOne&& collide_one) {
    thread_local CellSample sample;
    const auto rows = step.groups[group];
    sample.gather(rows, step.mixture, particles);
    const double thermal = sample.translational() + sample.internal();
    const Heat heat = step.heat_of(rows, particles);
    sample.heat = (heat.factor - 1.0) * thermal + heat.per_mass * sample.mass;
    sample.refused = 0.0;
    CollisionReport report{thermal};
    Random draw(step.seed, Stream::COLLISION, step.step, group);
    if (!collide_one(sample, draw, rows)) report.unrelaxed = 1;
    report.refused = sample.refused;
    sample.scatter(rows, particles);
    return report;
}

/// The same for each group.
template <class CollideOne>
CollisionReport for_each_group(const CollisionStep& step, Particles& particles,
                               CollideOne&& collide_one) {
    constexpr std::size_t GROUPS_A_CHUNK = 16;
    return parallel::sum(
        step.groups.size(), CollisionReport{},
        [&](std::size_t g) { return collide_one_group(step, g, particles, collide_one); },
        GROUPS_A_CHUNK);
}

}  // namespace corpuscle::gas
