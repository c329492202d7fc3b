// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <map>
#include <vector>

#include "fabric/membrane_setup.hpp"

namespace corpuscle::fabric {

/// The cloth of one coated part as its reference shape: where it runs on, and what curvature its
/// nodes' places mean.
///
/// The second derivatives of the places at node n over the flat cloth are those of the quadratic
/// through n that fits its neighbours m best, each with weight 1/|q|², q = X_m - X_n:
///
///     x_m - x_n ≈ g q + ½ qᵀ H q,   H_k = Σ_m w_mk (x_m - x_n),   k = 11, 22, 12
///
/// exact for any quadratic on any mesh. Neighbours are the nodes of the shells around n, and where
/// these are fewer than eight, those of the shells beyond: nodes that four triangles surround see
/// no twist without.
class CoatPatch {
public:
    struct Neighbour {
        Index row;
        std::array<double, 3> weight;  ///< w_mk                                       [1/m^2]
    };
    struct Node {
        Index row;
        bool is_inner = true;        ///< every edge at it has two shells or more
        bool bends = true;           ///< and runs on flat
        double area = 0.0;           ///< its share of the shells around it               [m^2]
        double reckoned_area = 0.0;  ///< with its share of those that do not bend        [m^2]
        std::vector<Neighbour> neighbours;
    };

    CoatPatch(const MembraneSetup& setup, Index part);

    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }  ///< rows ascending
    [[nodiscard]] std::size_t inner_count() const;
    [[nodiscard]] std::size_t sewn_count() const;  ///< inner nodes that do not bend

private:
    /// One shell: distinct corners with their reference places.
    struct CoatTriangle {
        int count;
        std::array<Index, 4> node;
        std::array<Vec3, 4> X;
        Vec3 normal;  ///< unit
        double area;  ///< [m^2]
    };
    using Edge = std::pair<Index, Index>;  ///< node rows, ascending

    void add_pieces(const MembraneSetup& setup, Index part);
    void find_edges();
    [[nodiscard]] bool runs_on(const Edge& edge) const;
    [[nodiscard]] std::map<Index, Vec3> places_around(const Node& node) const;
    void fit(Node& node) const;
    void share_areas();
    Node& at(Index node) { return nodes_[place_.at(node)]; }

    std::vector<CoatTriangle> triangles_;
    std::vector<Node> nodes_;
    std::map<Index, std::size_t> place_;               ///< of a node in nodes_
    std::map<Index, std::vector<std::size_t>> fan_;    ///< pieces round a node
    std::map<Edge, std::vector<std::size_t>> beside_;  ///< pieces at an edge
};

}  // namespace corpuscle::fabric
