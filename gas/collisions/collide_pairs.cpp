// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/collide.hpp"
#include "gas/collisions/each_group.hpp"
#include "gas/collisions/relax.hpp"

namespace corpuscle::gas {

/// Each particle of a group collides once, with a partner drawn at random; then internal energy and
/// translation are shared out anew. Collision steps of c_T dt / h = .25 or so, c_T = sqrt(R T / M),
/// give a mean free path of about a cell h.
CollisionReport collide_pairs(const CollisionStep& step, Particles& particles) {
    return for_each_group(step, particles, [&](CellSample& sample, Random& draw, auto) {
        const bool is_relaxed = relax(step.mixture, sample, draw);
        if (is_relaxed) sample.collide_pairs(draw);
        return is_relaxed;
    });
}

}  // namespace corpuscle::gas
