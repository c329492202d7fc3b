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

/// Sides of all shells and diagonals 1-3 of quads, and which shells have them.
class Lines {
public:
    explicit Lines(const Model& model) : shells_(model.shells) {
        for (std::size_t s = 0; s < shells_.size(); ++s) {
            const auto& n = shells_[s].nodes;
            const std::size_t corners = shells_[s].is_triangle() ? 3 : 4;
            const auto shell = static_cast<Index>(s);
            for (std::size_t k = 0; k < corners; ++k)
                all_.emplace_back(edge(n[k], n[(k + 1) % corners]), shell);
            if (corners == 4) all_.emplace_back(edge(n[0], n[2]), shell);
        }
        std::sort(all_.begin(), all_.end());
    }

    /// Has a shell of other nodes than these this line?
    [[nodiscard]] bool has(const Edge& line, const std::array<Index, 4>& nodes) const {
        auto at = std::lower_bound(all_.begin(), all_.end(), std::pair{line, Index{-1}});
        for (; at != all_.end() && at->first == line; ++at)
            if (!std::is_permutation(nodes.begin(), nodes.end(), shells_[at->second].nodes.begin()))
                return true;
        return false;
    }

private:
    const std::vector<Shell>& shells_;
    std::vector<std::pair<Edge, Index>> all_;
};

}  // namespace

SceneTriangles triangles_of(const Model& model, const std::vector<bool>& wanted) {
    const TiedEdges edges(model.tied_nodes);
    const Lines lines(model);
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
        } else if (!lines.has(edge(n[0], n[2]), n) || lines.has(edge(n[1], n[3]), n)) {
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
