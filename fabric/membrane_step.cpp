// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <cmath>

#include "fabric/element_frequency.hpp"
#include "fabric/membrane_block.hpp"
#include "fabric/membranes.hpp"

namespace corpuscle::fabric {

/// The step of the reference shapes, for use before any force is known.
void Membranes::find_rest_step() {
    double rate = 0.0;
    step_ = {INF, -1};
    for (const auto& block : blocks_)
        for (std::size_t e = 0; e < block->size(); ++e)
            if (block->rate(e) > rate) {
                rate = block->rate(e);
                step_ = {2.0 / std::sqrt(rate), block->shells[e]};
            }
}

Membranes::AddedMass Membranes::scale_mass(double step, Scaling where) {
    AddedMass added{std::vector<double>(node_count_, 0.0), 0.0};
    for (const auto& block : blocks_)
        for (std::size_t e = 0; e < block->size(); ++e) {
            const double factor =
                mass_factor(block->frequency_squared(e), block->damping_time(e), step);
            if (where == Scaling::WHERE_NEEDED && factor <= 1.0) continue;
            const double more = (factor - 1.0) * block->mass[e];
            for (int c = 0; c < block->corners; ++c)
                added.node[static_cast<std::size_t>(block->node(e, c))] += more / block->corners;
            added.total += more;
            block->set_rate(e, 4.0 / (step * step));
        }
    find_rest_step();
    return added;
}

}  // namespace corpuscle::fabric
