// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Membranes on the reference geometry that counts at a time.

#include "solver/scene/reference_geometry.hpp"
#include "solver/simulation.hpp"

namespace corpuscle {

/// Nodes of strained shells that are free to move.
std::vector<Index> Simulation::fabric_nodes() const {
    const std::vector<std::uint8_t> held = held_nodes();
    std::vector<std::uint8_t> is_in(nodes_.size(), 0);
    for (std::size_t s = 0; s < active_.size(); ++s)
        for (const Index n : model_.shells[s].nodes) is_in[n] = active_[s] | is_in[n];
    std::vector<Index> nodes;
    for (std::size_t n = 0; n < is_in.size(); ++n)
        if (is_in[n] && !held[n]) nodes.push_back(static_cast<Index>(n));
    return nodes;
}

/// Shortest edge of the shells at each node, in the reference shape; INF where there are none. [m]
std::vector<double> Simulation::fabric_sizes() const {
    std::vector<double> size(nodes_.size(), INF);
    for (std::size_t s = 0; s < active_.size(); ++s) {
        if (!active_[s]) continue;
        const auto& nodes = model_.shells[s].nodes;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            const std::size_t next = (k + 1) % nodes.size();
            const double length = (reference_[s][next] - reference_[s][k]).norm();
            if (nodes[k] == nodes[next]) continue;  // a triangle
            for (const Index n : {nodes[k], nodes[next]}) size[n] = std::min(size[n], length);
        }
    }
    return size;
}

/// The membranes with the reference geometry that counts at t, on the masses of the reference
/// shape.
fabric::Membranes Simulation::membranes_at(double t) const {
    const auto corners = corners_at(t, births_, reference_, model_);
    fabric::MembraneSetup setup{model_.shells, model_.parts,    model_.materials, reference_,
                                active_,       model_.x.size(), model_.curves,    nodes_.x};
    const std::vector<double> mass = fabric::lumped_mass(setup);  // rigid bodies' nodes too
    setup.reference = corners;
    setup.node_mass = mass;
    return fabric::Membranes(setup);
}

/// Shells whose time has come are measured against their reference geometry from now on. What they
/// store more, or less, is work from outside.
void Simulation::bear_references() {
    if (clock_.t < next_birth_) return;
    std::vector<std::uint8_t> is_new(births_.size());
    for (std::size_t s = 0; s < is_new.size(); ++s)
        is_new[s] = births_[s] >= next_birth_ && births_[s] <= clock_.t;
    next_birth_ = next_birth(clock_.t, births_);
    for (fabric::Membranes& fabric : fabric_) {
        const auto stored = [&](fabric::Membranes& membranes) {
            if (const Index broken = membranes.add_force(nodes_.x, nodes_.v, nodes_.f); broken >= 0)
                stop_for(broken);
            return membranes.strain_energy() + membranes.lost_energy();
        };
        const double before = stored(fabric);
        fabric::Membranes now = membranes_at(clock_.t);
        now.inherit(fabric, is_new);
        fabric = std::move(now);
        const double more = stored(fabric) - before;
        ledger_.before.external += more;
        ledger_.after.external += more;
        growth_.give(more);
    }
}

}  // namespace corpuscle
