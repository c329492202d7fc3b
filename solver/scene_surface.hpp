// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/base/surface.hpp"
#include "solver/model.hpp"

namespace corpuscle {

/// Shells cut into triangles (quads along nodes 1-3), with the shell that each came from.
struct SceneTriangles {
    std::vector<Triangle> triangles;
    std::vector<Index> shell;
};

/// The triangles of the parts that `wanted[part row]` marks.
inline SceneTriangles triangles_of(const Model& model, const std::vector<bool>& wanted) {
    SceneTriangles cut;
    for (std::size_t s = 0; s < model.shells.size(); ++s) {
        const Shell& shell = model.shells[s];
        if (!wanted[shell.part]) continue;
        const auto& n = shell.nodes;
        cut.triangles.push_back({n[0], n[1], n[2]});
        cut.shell.push_back(static_cast<Index>(s));
        if (shell.is_triangle()) continue;
        cut.triangles.push_back({n[0], n[2], n[3]});
        cut.shell.push_back(static_cast<Index>(s));
    }
    return cut;
}

}  // namespace corpuscle
