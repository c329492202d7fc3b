// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "solver/base/vec.hpp"

namespace corpuscle::tools {

/// A facet with its thickness: a flat prism about three or more corners.
struct Prism {
    std::vector<Vec3> corners;  ///< round the middle plane, not on one line; convex         [m]
    double thickness = 0.0;     ///< > 0                                                     [m]
};

/// How far one of two prisms must be moved, at least, so that they touch no more; 0 where they are
/// apart. The least overlap along the axes of separation [Gottschalk, Lin & Manocha 1996]: normals
/// of faces, and what is square to an edge of each. Exact for flat facets.                  [m]
[[nodiscard]] double crossing_depth(const Prism& a, const Prism& b);

}  // namespace corpuscle::tools
