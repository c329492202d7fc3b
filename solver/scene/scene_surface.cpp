// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "solver/scene/scene_surface.hpp"

#include <algorithm>
#include <utility>

namespace corpuscle {
namespace {

using Edge = std::pair<Index, Index>;

Edge edge(Index a, Index b) {
    return {std::min(a, b), std::max(a, b)};
}

/// Sides of the wanted shells and diagonals 1-3 of their quads, sorted; as often as shells have them.
std::vector<Edge> lines_of(const Model& model, const std::vector<bool>& wanted) {
    std::vector<Edge> lines;
    for (const Shell& shell : model.shells) {
        if (!wanted[shell.part]) continue;
        const auto& n = shell.nodes;
        const std::size_t corners = shell.is_triangle() ? 3 : 4;
        for (std::size_t k = 0; k < corners; ++k) lines.push_back(edge(n[k], n[(k + 1) % corners]));
        if (corners == 4) lines.push_back(edge(n[0], n[2]));
    }
    std::sort(lines.begin(), lines.end());
    return lines;
}

}  // namespace

SceneTriangles triangles_of(const Model& model, const std::vector<bool>& wanted) {
    const TiedEdges edges(model.tied_nodes);
    const std::vector<Edge> lines = lines_of(model, wanted);
    const auto count = [&](const Edge& line) {
        const auto [first, last] = std::equal_range(lines.begin(), lines.end(), line);
        return last - first;
    };
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
        const auto& n = shell.nodes;
        if (shell.is_triangle()) {
            add({n[0], n[1], n[2]}, s);
        } else if (count(edge(n[0], n[2])) == 1 || count(edge(n[1], n[3])) > 0) {
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
