// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "solver/base/surface.hpp"
#include "solver/bodies/tied_nodes.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Shells cut into triangles, with the shell that each came from.
struct SceneTriangles {
    std::vector<Triangle> triangles;
    std::vector<Index> shell;
};

/// Nodes of a shell from the one that a quad is cut at, which is cut between the first and the
/// third of them: of a mirrored quad its second, so that the cut is the mirror image's.
[[nodiscard]] std::array<Index, 4> cutting_order(const Model& model, std::size_t shell);

/// The triangles of the parts that `wanted[part row]` marks. A quad is cut from the first node of
/// its cutting_order() to the third; from the second to the fourth where the first way is also a side or a diagonal of
/// another shell (the corner of a flat bag whose two panels share their rim: both would be cut
/// between the same two nodes, and four triangles meet in one edge). Nodes that are tied in one
/// place count as one, and edges are cut at nodes that are tied to them.
[[nodiscard]] SceneTriangles triangles_of(const Model& model, const std::vector<bool>& wanted);

}  // namespace corpuscle
