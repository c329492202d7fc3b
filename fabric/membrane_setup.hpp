// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "fabric/materials/fabric_card.hpp"
#include "fabric/mesh.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::fabric {

/// What membranes are made of: views, only read during construction.
struct MembraneSetup {
    std::span<const Shell> shells;                   ///< E, nodes and part by row
    std::span<const Part> parts;                     ///< P, material by row
    std::span<const Material> materials;             ///< M
    std::span<const std::array<Vec3, 4>> reference;  ///< E × 4 stress-free corners              [m]
    std::span<const std::uint8_t>
        active;                       ///< E; 0: never strained (all nodes supported, rigid, null)
    std::size_t node_count = 0;       ///< N, of the whole scene
    std::span<const Curve> curves{};  ///< that the materials' rows mean
    std::span<const Vec3> start{};    ///< N: places at the start, for TSRFAC; empty: no strain [m]
    std::span<const double> node_mass{};  ///< N; empty: lumped_mass() of this setup           [kg]
};

/// Mass of every shell, whatever it is made of, from its reference area: rho·h·A0.     E    [kg]
std::vector<double> shell_mass(const MembraneSetup& setup);

/// The shells' masses shared out equally among their corners.                          N    [kg]
std::vector<double> lumped_mass(const MembraneSetup& setup);

}  // namespace corpuscle::fabric
