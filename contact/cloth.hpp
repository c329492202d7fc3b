// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/cards.hpp"
#include "contact/distance.hpp"
#include "contact/patches.hpp"
#include "solver/base/curve.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::contact {

/// What self-contact is built from. Spans need to live during construction only.
struct ContactSetup {
    ContactCard card;
    std::vector<Triangle> triangles;
    std::vector<double> thickness;           ///< of the section, per triangle                [m]
    std::span<const double> node_mass;       ///< N                                           [kg]
    std::span<const Vec3> reference_x;       ///< stress-free node positions, N × 3           [m]
    std::span<const Vec3> x0;                ///< node positions at the start, N × 3          [m]
    const Curve* thickness_curve = nullptr;  ///< of card.thickness_curve, or none
    std::span<const std::uint8_t> held;      ///< N: 1 = moves as prescribed, whatever hits it
};

/// What contact knows of the fabric and what never changes.
struct Cloth {
    std::vector<Triangle> triangles;
    std::vector<double> thickness;    ///< contact thickness by triangle                [m]
    double greatest_thickness = 0.0;  ///< [m]
    double mean_edge = 0.0;  ///< mean length of the edges, each seen from its triangles  [m]
    std::vector<double> inverse_mass;  ///< by node row; 0: held                         [1/kg]
    Points reference_x, x0;            ///< by node row, N × 3                           [m]

    /// Each node and each edge belongs to just one of the triangles that have it, so that a pair of
    /// them is met once. Bits 0-2: node k is this triangle's; bits 3-5: edge k -> k + 1 is.
    std::vector<std::uint8_t> owned;
    std::vector<std::array<Index, 3>> edge;  ///< by triangle: names of its edges k -> k + 1

    Patches patches;
    std::vector<Index> patch_of;    ///< by triangle
    std::vector<Index> patch_node;  ///< nodes of patch p: patch_node[patch_node_start[p]] ...
    std::vector<Index> patch_node_start;

    std::vector<Index> near_node;  ///< nodes beside node i on the cloth, ascending
    std::vector<Index> near_start;

    explicit Cloth(const ContactSetup& setup);

    [[nodiscard]] std::span<const Index> nodes_of_patch(std::size_t p) const {
        return std::span(patch_node)
            .subspan(patch_node_start[p], patch_node_start[p + 1] - patch_node_start[p]);
    }
    [[nodiscard]] bool owns_node(Index triangle, int k) const { return owned[triangle] >> k & 1; }
    [[nodiscard]] bool owns_edge(Index triangle, int k) const {
        return owned[triangle] >> (3 + k) & 1;
    }
    /// Whether nothing can move the pair.
    [[nodiscard]] bool is_held(const Pair& pair) const {
        double mobility = 0.0;
        for (const Index node : pair.node) mobility += inverse_mass[node];
        return mobility == 0.0;
    }
    [[nodiscard]] bool are_beside(Index node, Index other) const;
};

}  // namespace corpuscle::contact
