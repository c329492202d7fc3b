// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/enclosure/wetted_surface.hpp"

namespace corpuscle::gas {

/// Wall points of each node that has any, or that are told.
struct NodePoints {
    std::vector<Index> nodes;          ///< rows of x, once each
    std::vector<Index> start, points;  ///< of `nodes`, compressed rows
    std::vector<Index> place;          ///< N: in `nodes`, -1: not there

    NodePoints() = default;
    /// @param more   nodes that count without a point
    /// @param count  of all nodes
    NodePoints(const WettedSurface& surface, std::span<const Index> more, std::size_t count);
};

}  // namespace corpuscle::gas
