// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/base/surface.hpp"
#include "solver/bodies/tied_nodes.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Shells cut into triangles (quads along nodes 1-3, edges at tied nodes), with the shell that each came from.
struct SceneTriangles {
    std::vector<Triangle> triangles;
    std::vector<Index> shell;
};

/// The triangles of the parts that `wanted[part row]` marks, cut at tied nodes.
inline SceneTriangles triangles_of(const Model& model, const std::vector<bool>& wanted) {
    const TiedEdges edges(model.tied_nodes);
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
        add({n[0], n[1], n[2]}, s);
        if (!shell.is_triangle()) add({n[0], n[2], n[3]}, s);
    }
    return cut;
}

}  // namespace corpuscle
