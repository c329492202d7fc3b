// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "tools/fold/mesh/improve.hpp"

namespace corpuscle::fold {

/// By node: the nodes that it has an edge with, its cells.
struct Neighbours {
    std::vector<std::vector<Index>> nodes, cells;
    explicit Neighbours(const Sheet& sheet);
};

/// Of some cells. [m]
[[nodiscard]] double least_reach(const std::vector<Index>& cells, const Sheet& sheet);

[[nodiscard]] inline bool may_move(const Vec3& X, const Freedom& freedom) {
    return !freedom.is_free || freedom.is_free(X);
}

}  // namespace corpuscle::fold
