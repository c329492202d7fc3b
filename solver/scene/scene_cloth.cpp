// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Membranes on the reference geometry that counts at a time.

#include <algorithm>
#include <utility>

#include "solver/scene/reference_geometry.hpp"
#include "solver/scene/scene_state.hpp"
#include "solver/stops.hpp"

namespace corpuscle {

/// Nodes of strained shells that are free to move.
std::vector<Index> SceneState::fabric_nodes() const {
    const std::vector<std::uint8_t> held = held_nodes();
    std::vector<std::uint8_t> is_in(nodes.size(), 0);
    for (std::size_t s = 0; s < cloth.active.size(); ++s)
        for (const Index n : model.shells[s].nodes) is_in[n] = cloth.active[s] | is_in[n];
    std::vector<Index> free;
    for (std::size_t n = 0; n < is_in.size(); ++n)
        if (is_in[n] && !held[n]) free.push_back(static_cast<Index>(n));
    return free;
}

/// Shortest edge of the shells at each node, in the reference shape; INF where there are none. [m]
std::vector<double> SceneState::fabric_sizes() const {
    std::vector<double> size(nodes.size(), INF);
    for (std::size_t s = 0; s < cloth.active.size(); ++s) {
        if (!cloth.active[s]) continue;
        const auto& corners = model.shells[s].nodes;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::size_t next = (k + 1) % corners.size();
            const double length = (cloth.reference[s][next] - cloth.reference[s][k]).norm();
            if (corners[k] == corners[next]) continue;  // a triangle
            for (const Index n : {corners[k], corners[next]}) size[n] = std::min(size[n], length);
        }
    }
    return size;
}

/// The membranes with the reference geometry that counts, born before the next birth to come, on
/// the masses of the reference shape.
fabric::Membranes SceneState::membranes_now() const {
    const auto corners = corners_before(cloth.next_birth, cloth.births, cloth.reference, model);
    fabric::MembraneSetup setup{model.shells, model.parts,    model.materials, cloth.reference,
                                cloth.active, model.x.size(), model.curves,    nodes.x};
    const std::vector<double> mass = fabric::lumped_mass(setup);  // rigid bodies' nodes too
    setup.reference = corners;
    setup.node_mass = mass;
    return fabric::Membranes(setup);
}

/// Shells whose time has come are measured against their reference geometry from now on. What they
/// store more, or less, is work from outside.
void SceneState::activate_references() {
    if (clock.t < cloth.next_birth) return;
    std::vector<std::uint8_t> is_new(cloth.births.size());
    for (std::size_t s = 0; s < is_new.size(); ++s)
        is_new[s] = cloth.births[s] >= cloth.next_birth && cloth.births[s] <= clock.t;
    cloth.next_birth = next_birth(clock.t, cloth.births);
    if (!cloth.membranes) return;
    fabric::Membranes& old = *cloth.membranes;
    const auto stored = [&](fabric::Membranes& membranes) {
        if (const Index broken = membranes.add_force(nodes.x, nodes.v, nodes.f); broken >= 0)
            stop_for_strain(*this, broken);
        return membranes.strain_energy() + membranes.lost_energy();
    };
    const double before = stored(old);
    fabric::Membranes now = membranes_now();
    now.inherit(old, is_new);
    old = std::move(now);
    const double more = stored(old) - before;
    ledger.before.external += more;
    ledger.after.external += more;
    cloth.growth.give(more);
    cloth.strained_start.begin(old.stable_step().dt);
}

}  // namespace corpuscle
