// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Which part of a triangle a b c (0 1 2) is nearest to a point.
enum class TriangleRegion { NODE_0, NODE_1, NODE_2, EDGE_01, EDGE_12, EDGE_20, INSIDE };

struct TriangleFoot {
    TriangleRegion region;
    Vec3
        weights;  ///< barycentric, of a b c: the foot is weights[0] a + weights[1] b + weights[2] c
};

/// Foot of p on triangle a b c: its nearest point. Triangles without area are legal.
///
/// cost: at most 3 div, no sqrt
/// Source: the regions of the plane around a triangle [Ericson 2005, 5.1.5].
[[nodiscard]] TriangleFoot foot_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b,
                                            const Vec3& c);

/// Where two segments are nearest to each other.
enum class EdgeRegion {
    INSIDE,   ///< within both
    END,      ///< at an end of one or both: a node-triangle pair sees that too
    PARALLEL  ///< nowhere in particular; the places given are ends
};

struct EdgeFeet {
    EdgeRegion region;
    double s, t;  ///< the places are p0 + s (p1 - p0) and q0 + t (q1 - q0), in [0, 1]
};

/// Nearest places of segments p0 p1 and q0 q1. Segments without length are legal.
///
/// cost: at most 3 div, no sqrt
/// Source: [Ericson 2005, 5.1.9].
[[nodiscard]] EdgeFeet feet_of_edges(const Vec3& p0, const Vec3& p1, const Vec3& q0,
                                     const Vec3& q1);

}  // namespace corpuscle::contact
