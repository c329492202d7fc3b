// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Foot of p on triangle a b c, its nearest point, in barycentric weights: w[0] a + w[1] b + w[2] c.
/// Triangles without area are legal.
///
/// cost: at most 3 div, no sqrt
/// Source: the regions of the plane around a triangle [Ericson 2005, 5.1.5].
[[nodiscard]] Vec3 foot_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

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
