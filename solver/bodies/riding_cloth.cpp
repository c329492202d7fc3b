// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/bodies/riding_cloth.hpp"

#include "solver/bodies/rigid_body.hpp"
#include "solver/bodies/rigid_parts.hpp"
#include "solver/bodies/tied_nodes.hpp"

namespace corpuscle {

std::vector<double> mass_at_nodes(const Model& model, const std::vector<double>& shell_mass,
                                  const TiedNodes& ties, const std::vector<std::uint8_t>& counts) {
    std::vector<double> mass(model.x.size(), 0.0);
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        const Shell& shell = model.shells[s];
        if (!counts[shell.part]) continue;
        const int corners = shell.is_triangle() ? 3 : 4;
        for (int k = 0; k < corners; ++k) mass[shell.nodes[k]] += shell_mass[s] / corners;
    }
    ties.share_mass(mass);
    return mass;
}

std::vector<RidingNode> riding_cloth(const Model& model, const std::vector<RigidBody>& bodies,
                                     const std::vector<double>& shell_mass, const TiedNodes& ties,
                                     const std::vector<double>& node_mass) {
    std::vector<RidingNode> riding;
    if (bodies.empty()) return riding;
    std::vector<std::uint8_t> is_cloth(model.parts.size());
    for (std::size_t p = 0; p < is_cloth.size(); ++p)
        is_cloth[p] = !is_rigid(model, static_cast<Index>(p));
    const std::vector<double> cloth = mass_at_nodes(model, shell_mass, ties, is_cloth);
    const std::vector<double> all =
        mass_at_nodes(model, shell_mass, ties, std::vector<std::uint8_t>(model.parts.size(), 1));
    for (std::size_t b = 0; b < bodies.size(); ++b)
        for (const Index n : nodes_of_rigid_parts(model, parts_of_nodes(model, bodies[b].parts())))
            if (cloth[n] > 0.0)
                riding.push_back({n, static_cast<Index>(b), cloth[n], node_mass[n],
                                  cloth[n] / all[n] * node_mass[n]});
    return riding;
}

}  // namespace corpuscle
