// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/scene_surface.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace corpuscle {
namespace {

using Edge = std::pair<Index, Index>;

Edge edge(Index a, Index b) {
    return {std::min(a, b), std::max(a, b)};
}

using Corners = std::array<Index, 4>;

/// In cutting order, tied nodes of one place being one.
Corners tied_corners(Corners corners, const TiedEdges& ties) {
    for (Index& node : corners) node = ties.node_for(node);
    return corners;
}

/// Sides of all shells and first diagonals of quads, and which shells have them.
class Lines {
public:
    Lines(const Model& model, const TiedEdges& ties) {
        for (std::size_t s = 0; s < model.shells.size(); ++s) {
            const Corners n = tied_corners(cutting_order(model, s), ties);
            const std::size_t count = model.shells[s].is_triangle() ? 3 : 4;
            const auto shell = static_cast<Index>(s);
            for (std::size_t k = 0; k < count; ++k)
                all_.emplace_back(edge(n[k], n[(k + 1) % count]), shell);
            if (count == 4) all_.emplace_back(edge(n[0], n[2]), shell);
            shells_.push_back(n);
        }
        std::sort(all_.begin(), all_.end());
    }

    /// Has a shell of other nodes than these this line?
    [[nodiscard]] bool has(const Edge& line, const Corners& nodes) const {
        auto at = std::lower_bound(all_.begin(), all_.end(), std::pair{line, Index{-1}});
        for (; at != all_.end() && at->first == line; ++at)
            if (!std::is_permutation(nodes.begin(), nodes.end(), shells_[at->second].begin()))
                return true;
        return false;
    }

private:
    std::vector<Corners> shells_;
    std::vector<std::pair<Edge, Index>> all_;
};

}  // namespace

std::array<Index, 4> cutting_order(const Model& model, std::size_t shell) {
    std::array<Index, 4> nodes = model.shells[shell].nodes;
    const auto& mirrored = model.mirrored_quads;
    if (std::binary_search(mirrored.begin(), mirrored.end(), static_cast<Index>(shell)))
        std::rotate(nodes.begin(), nodes.begin() + 1, nodes.end());
    return nodes;
}

SceneTriangles triangles_of(const Model& model, const std::vector<bool>& wanted) {
    const TiedEdges edges(model.tied_nodes);
    const Lines lines(model, edges);
    SceneTriangles cut;
    const auto add = [&](const Triangle& whole, std::size_t shell) {
        edges.cut(whole, [&](const Triangle& piece) {
            cut.triangles.push_back(piece);
            cut.shell.push_back(static_cast<Index>(shell));
        });
    };
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        const Shell& shell = model.shells[s];
        if (!wanted[shell.part]) continue;
        const Corners n = cutting_order(model, s), at = tied_corners(n, edges);
        if (shell.is_triangle()) {
            add({n[0], n[1], n[2]}, s);
        } else if (!lines.has(edge(at[0], at[2]), at) || lines.has(edge(at[1], at[3]), at)) {
            add({n[0], n[1], n[2]}, s);
            add({n[0], n[2], n[3]}, s);
        } else {
            add({n[1], n[2], n[3]}, s);
            add({n[1], n[3], n[0]}, s);
        }
    }
    return cut;
}

}  // namespace corpuscle
