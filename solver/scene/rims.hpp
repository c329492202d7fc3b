// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "solver/base/surface.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Edges by their ends, lower row first.
using EdgeSet = std::set<std::pair<Index, Index>>;

/// Rows of the shells of a part.
[[nodiscard]] std::vector<Index> shells_of(const Model& model, Index part);

/// Edges of shells that one of them has alone; those with tied nodes on them are divided there.
[[nodiscard]] EdgeSet free_edges(const Model& model, const std::vector<Index>& shells);

/// Free edges a-b beside which other free edges run from a to b over nodes that lie on it: these
/// nodes hang there, tied to a and b from now on. On it: within a twentieth of its length.
[[nodiscard]] std::vector<TiedNode> hanging_nodes(const Model& model, const EdgeSet& free);

/// Free edges that hang together.
struct Hole {
    std::vector<Index> rim;  ///< nodes; in their order along the rim if it is a loop
    std::size_t edges = 0;
    bool is_loop = false;        ///< every node of the rim has two of its edges
    Vec3 centre = Vec3::Zero();  ///< mean of the nodes                                    [m]
    double width = 0.0;          ///< greatest distance of two nodes                       [m]
    double area = 0.0;           ///< of the lid over a loop                             [m^2]

    /// "a hole of 8 edges about (0, 0, 0.1), 0.2 wide, of area 0.01, at nodes 4, 5, 6 ..."
    [[nodiscard]] std::string text(const Model& model) const;
};
[[nodiscard]] std::vector<Hole> holes(const Model& model, const std::vector<Index>& shells);

/// Triangles over a closed rim, without further nodes: ears are cut off one by one, the best shaped
/// first.
[[nodiscard]] std::vector<Triangle> lid_over(const std::vector<Index>& rim, const Points& x);

/// Of shells at the start.                                                              [m^2]
[[nodiscard]] double area_of(const Model& model, const std::vector<Index>& shells);

}  // namespace corpuscle
