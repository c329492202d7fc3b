// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "solver/base/surface.hpp"

namespace corpuscle::contact {

/// Points in a plane, single precision.                                                     [m]
struct PlanePoints {
    std::vector<float> x, y;
};

/// The rim of a piece of surface: its directed edges that no triangle has the other way round, one
/// behind the other. Empty where they are not one closed line without a corner twice, or two
/// triangles have an edge the same way round.
/// @param forks  nodes that are corners more than once
[[nodiscard]] std::vector<Index> rim_of(std::span<const Triangle> triangles,
                                        std::vector<Index>& forks);

/// Least square of the heights of triangles, counter-clockwise in the plane; 0: one is not.  [m^2]
[[nodiscard]] float least_height_square(const PlanePoints& at, std::span<const Triangle> triangles);

/// Least square distance of a closed line's corners, the first points, from those of its edges that
/// do not have them, or `most` where all are farther; 0 where edges cross.                [m^2]
[[nodiscard]] float rim_distance_square(const PlanePoints& at, std::size_t corners, float most);

}  // namespace corpuscle::contact
