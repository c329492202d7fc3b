// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Which part of a triangle a b c (0 1 2) is nearest to a point.
enum class TriangleRegion { NODE_0, NODE_1, NODE_2, EDGE_01, EDGE_12, EDGE_20, INSIDE };

/// Place on a triangle a b c that is nearest to a point.
struct TriangleFoot {
    TriangleRegion region;  ///< where it lies: within, on an edge or on a node
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
    INSIDE,  ///< within both
    END      ///< at an end of one or both: a node-triangle pair sees that too
};

/// Places on two segments, p0 p1 and q0 q1, that are nearest to each other.
struct EdgeFeet {
    EdgeRegion region;  ///< INSIDE: their vector is normal to both segments
    double s,           ///< the first place is p0 + s (p1 - p0), in [0, 1]  [-]
        t;              ///< the second place is q0 + t (q1 - q0), in [0, 1]  [-]
};

/// Nearest places of segments p0 p1 and q0 q1. Segments that are parallel or have no length are
/// legal.
///
/// cost: at most 5 div, no sqrt
/// Source: the solution within both, clamped one after the other [Ericson 2005, 5.1.9]; of
/// parallels the best of the four ends.
[[nodiscard]] EdgeFeet feet_of_edges(const Vec3& p0, const Vec3& p1, const Vec3& q0,
                                     const Vec3& q1);

/// A node and a triangle (its three nodes), or two edges (first's two nodes, second's two).
struct Pair {
    std::array<Index, 4> node;  ///< rows: of the first side, then of the second
    bool is_edges;              ///< two edges, 2 + 2; else a node and a triangle, 1 + 3
};

/// Their nearest places: the vector between them is sum of weight · x, from the second to the
/// first.
struct Nearest {
    std::array<double, 4> weight;  ///< add up to zero
    Vec3 apart;                    ///< [m]
    bool is_inside;                ///< within both edges; for a node and a triangle always
};

/// A value of each of a pair's nodes: positions, displacements.
using Corners = std::array<Vec3, 4>;

/// The values of a pair's nodes, out of those by node row.
[[nodiscard]] inline Corners corners(const Pair& pair, const Points& of) {
    return {of[pair.node[0]], of[pair.node[1]], of[pair.node[2]], of[pair.node[3]]};
}

/// Bound of the rate at which the gap of a pair shrinks while its nodes move at v, or of how much
/// if they move by that: seen from their mean, both sides' fastest nodes head on.
[[nodiscard]] inline double greatest_approach(const Pair& pair, const Corners& v) {
    const Vec3 mean = 0.25 * (v[0] + v[1] + v[2] + v[3]);
    std::array<double, 4> square;
    for (int k = 0; k < 4; ++k) square[k] = (v[k] - mean).squaredNorm();
    return pair.is_edges
               ? std::sqrt(std::max(square[0], square[1])) +
                     std::sqrt(std::max(square[2], square[3]))
               : std::sqrt(square[0]) + std::sqrt(std::max({square[1], square[2], square[3]}));
}

/// Separation of a pair's two sides along a direction: no node of the first is nearer to one of the
/// second than that, seen along it. Along the line between their nearest places it is the gap. [m]
[[nodiscard]] double separation(const Pair& pair, const Vec3& direction, const Corners& x);

/// The nearest places of a pair whose nodes are at x.
[[nodiscard]] Nearest nearest(const Pair& pair, const Corners& x);

/// The same of nodes at x, by node row.                                                    [m]
[[nodiscard]] inline Nearest nearest(const Pair& pair, const Points& x) {
    return nearest(pair, corners(pair, x));
}

}  // namespace corpuscle::contact
