// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "solver/model.hpp"

namespace corpuscle {

class RigidBody;
class TiedNodes;

/// A node of cloth that rides on a rigid body, which has its mass.
struct RidingNode {
    Index node = -1;         ///< row
    Index body = -1;         ///< row among the bodies
    double by_shells = 0.0;  ///< mass that shells of cloth give it                        [kg]
    double all = 0.0;        ///< all of its mass                                          [kg]
    double mass = 0.0;       ///< of that, what cloth has by its share of the shells' mass   [kg]
};

/// Mass that the shells of some parts give to nodes, and of tied nodes to those that bear it. N [kg]
/// @param shell_mass  E                                                                   [kg]
/// @param counts      by part row, 1 for those parts
[[nodiscard]] std::vector<double> mass_at_nodes(const Model& model,
                                                const std::vector<double>& shell_mass,
                                                const TiedNodes& ties,
                                                const std::vector<std::uint8_t>& counts);

/// Cloth whose nodes ride on bodies, or are tied to nodes that do. Nodes of *PART_INERTIA, solids
/// and beams give their body no mass, and are none of it.
/// @param shell_mass  E                                                                   [kg]
/// @param node_mass   N, with that of tied nodes at those that bear it                     [kg]
[[nodiscard]] std::vector<RidingNode> riding_cloth(const Model& model,
                                                   const std::vector<RigidBody>& bodies,
                                                   const std::vector<double>& shell_mass,
                                                   const TiedNodes& ties,
                                                   const std::vector<double>& node_mass);

}  // namespace corpuscle
