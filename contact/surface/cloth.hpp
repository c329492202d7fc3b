// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/geometry/distance.hpp"
#include "contact/surface/cards.hpp"
#include "contact/surface/patches.hpp"
#include "contact/surface/rules.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::contact {

/// What contact is built from. Spans need to live during construction only.
struct ContactSetup {
    std::vector<ContactCard> cards;   ///< in the deck's order (rules.hpp)
    std::vector<Triangle> triangles;  ///< of all parts that cards name, T × 3 node rows
    std::vector<Index> part;          ///< row of each triangle's part
    std::vector<double> thickness;    ///< of the section, per triangle; 0: a skin              [m]
    std::vector<double> modulus;      ///< through the thickness, per triangle; empty: 10 MPa   [Pa]
    std::size_t parts = 1;            ///< in the scene
    /// In which gaps that start below the contact thickness grow to it, but for 1/e; long against a
    /// step, so that nothing is thrown, and short against a deployment.                        [s]
    double growth_time = 1e-3;
    std::span<const double> node_mass;   ///< N; of rigid bodies' nodes: any               [kg]
    std::span<const Vec3> reference_x;   ///< stress-free node positions, N × 3            [m]
    std::span<const Vec3> x0;            ///< node positions at the start, N × 3           [m]
    std::span<const Curve> curves;       ///< of the scene
    std::span<const std::uint8_t> held;  ///< N: 1 = moves as prescribed, whatever hits it
    std::span<const std::uint8_t> held_axes = {};  ///< N: bits 0-2: x, y, z of free nodes held
    std::span<const Index> body = {};  ///< N: number of the rigid body it is of, or -1; empty: none
};

/// What contact knows of the fabric and of rigid bodies' surfaces, and what never changes.
struct Cloth {
    Rules rules;                                 ///< pairs of parts in contact, from the cards
    std::vector<Triangle> triangles;             ///< as set up, T × 3 node rows
    std::vector<Index> part;                     ///< by triangle: row of its part
    std::vector<std::vector<double>> thickness;  ///< contact thickness by card and triangle   [m]
    std::vector<double> node_thickness;          ///< by node: the greatest of its triangles   [m]
    double greatest_thickness = 0.0;             ///< [m]
    double growth_time = 0.0;     ///< of gaps that start below the thickness        [s]
    double mean_edge = 0.0;       ///< mean length of the edges, each seen from its triangles  [m]
    std::vector<double> modulus;  ///< by triangle: through the thickness            [Pa]
    std::vector<double> inverse_mass;  ///< by node row; 0: held, or of a rigid body     [1/kg]
    Points mobility;  ///< by node row and axis: likewise, 0 also along axes that are held [1/kg]
    std::vector<Index> body;  ///< by node row: number of its rigid body, or -1
    Points reference_x,       ///< stress-free, by node row, N × 3  [m]
        x0;                   ///< at the start, by node row, N × 3  [m]

    /// Each node and each edge belongs to just one of the triangles that have it, so that a pair of
    /// them is met once. Bits 0-2: node k is this triangle's; bits 3-5: edge k -> k + 1 is.
    std::vector<std::uint8_t> owned;
    std::vector<std::array<Index, 3>> edge;  ///< by triangle: names of its edges k -> k + 1
    /// Parts that nodes and edges touch by (rules.hpp): that of all their triangles, or, where cards
    /// tell these apart, a combined one.
    std::vector<Index> node_part,  ///< by node row; -1: of no triangle
        edge_part;                 ///< by name

    Patches patches;           ///< of the triangles, each compact along the cloth
    std::vector<Index> nodes;  ///< that triangles have, ascending

    /// By node row: least height over the opposite side of its triangles in the reference shape.
    /// Along the cloth, what does not have the node is at least this far from it.             [m]
    std::vector<double> star_height;

    std::vector<Index> node_triangle;             ///< triangles of node n, ascending
    std::vector<Index> node_start;                ///< where those of node n begin, N + 1
    std::vector<std::array<Index, 2>> node_edge;  ///< by entry: the triangle's other two nodes

    std::vector<Index> body_node;   ///< nodes of body b: body_node[body_start[b]] ...
    std::vector<Index> body_start;  ///< of numbers 0 ... greatest, and the end

    std::vector<Index> near_node;          ///< nodes beside node i on the cloth, ascending
    std::vector<Index> near_start;         ///< where those of node i begin, N + 1
    std::vector<std::uint64_t> near_bits;  ///< by node: bit n % 64 of each of those

    /// @throws InputError for a contact thickness that is not positive or a free node without mass
    explicit Cloth(const ContactSetup& setup);

    /// Rows of the triangles that have a node, ascending.
    [[nodiscard]] std::span<const Index> triangles_of(Index node) const {
        return std::span(node_triangle)
            .subspan(node_start[node], node_start[node + 1] - node_start[node]);
    }
    /// Of the same triangles the other two nodes.
    [[nodiscard]] std::span<const std::array<Index, 2>> edges_opposite(Index node) const {
        return std::span(node_edge).subspan(node_start[node],
                                            node_start[node + 1] - node_start[node]);
    }
    /// Whether pairs of node k of a triangle are met from this triangle.
    [[nodiscard]] bool owns_node(Index triangle, int k) const { return owned[triangle] >> k & 1; }
    /// Whether pairs of its edge k -> k + 1 are.
    [[nodiscard]] bool owns_edge(Index triangle, int k) const {
        return owned[triangle] >> (3 + k) & 1;
    }
    /// Whether nothing can move the pair's nodes against each other.
    [[nodiscard]] bool is_held(const Pair& pair) const;
    /// Node rows of a rigid body, ascending.
    /// @param b  its number, below body_start.size() - 1
    [[nodiscard]] std::span<const Index> nodes_of_body(std::size_t b) const {
        return std::span(body_node).subspan(body_start[b], body_start[b + 1] - body_start[b]);
    }
    /// Whether a node of the pair is one of a rigid body.
    [[nodiscard]] bool has_body(const Pair& pair) const {
        return body_start.size() > 1 && std::any_of(pair.node.begin(), pair.node.end(),
                                                    [&](Index n) { return body[n] >= 0; });
    }
    /// Contact thickness between the two sides of a pair by a card; that of a node or an edge is
    /// that of the first of its triangles which is on the card's side.                      [m]
    /// @param parts  by which the sides touch
    /// @param a, b   triangles that own them
    [[nodiscard]] double gap(int card, PartPair parts, const Pair& pair, Index a, Index b) const;
    /// Whether one of its nodes is of a combined part.
    [[nodiscard]] bool is_on_border(Index triangle) const {
        const Triangle& t = triangles[triangle];
        return std::any_of(t.begin(), t.end(),
                           [&](Index n) { return rules.is_combined(node_part[n]); });
    }
    /// Whether `other` has an edge in common with the node, or with one that is nearer to it along
    /// edges of the reference shape than twice the greatest contact thickness.
    [[nodiscard]] bool are_beside(Index node, Index other) const;
};

}  // namespace corpuscle::contact
