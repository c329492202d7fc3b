// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "gas/facet_lists.hpp"

namespace corpuscle::gas {

/// Eight numbers at once, on every processor.
using Eight = float __attribute__((vector_size(32)));

using Quad = float __attribute__((vector_size(16)));  ///< x, y, z, 0

/// Is any of a greater than its fellow in b?
inline bool any_greater(const Eight& a, const Eight& b) {
    const auto is_greater = a > b;
#ifdef __AVX__
    return __builtin_ia32_movmskps256(reinterpret_cast<Eight>(is_greater)) != 0;
#else
    bool any = false;
    for (int i = 0; i < 8; ++i) any |= is_greater[i] != 0;
    return any;
#endif
}

/// A piece of a path, from one instant of the step to another, in single precision: what
/// FacetBounds compare.
struct SmallPath {
    Eight box;                      ///< high, 0, -low, 0                                   [m]
    std::array<float, 3> from, to;  ///< from the bounds' origin                            [m]
    float after, before;            ///< shares of the step at its two ends                 [-]
    float slack;                    ///< more than rounding can be wrong                    [m]
};

/// What a facet sweeps in one step: its box, and a plane by which most paths pass on one side.
///
/// With n the facet's unit normal at t, all its nodes have the height n·x = at_0 at t and lie
/// between low_1 and high_1 at t + dt. In between, at the share tau of the step, any point that the
/// exact test (crossing.hpp) takes for the facet's lies between at_0 + tau (low_1 - at_0) and at_0
/// + tau (high_1 - at_0). A path that is above at both its ends, or below, misses it.
struct FacetBound {
    Eight box;                    ///< low, 0, -high, 0                                    [m]
    std::array<float, 3> normal;  ///< zero for a facet without area: no path is told apart
    float at_0, low_1, high_1;    ///< heights                                             [m]
    float size;                   ///< longest side of the box                             [m]

    /// Do the boxes overlap?
    [[nodiscard]] bool is_near(const SmallPath& path) const { return !any_greater(box, path.box); }

    /// Does the path stay on one side?
    [[nodiscard]] bool is_missed_by(const SmallPath& path) const {
        float h_0 = 0.0F, h_1 = 0.0F;
        for (int a = 0; a < 3; ++a) {
            h_0 += normal[a] * path.from[a];
            h_1 += normal[a] * path.to[a];
        }
        const float low = low_1 - at_0, high = high_1 - at_0;
        const float below_0 = at_0 + path.after * low - path.slack,
                    below_1 = at_0 + path.before * low - path.slack,
                    above_0 = at_0 + path.after * high + path.slack,
                    above_1 = at_0 + path.before * high + path.slack;
        return (h_0 < below_0 && h_1 < below_1) || (h_0 > above_0 && h_1 > above_1);
    }
};

/// Bounds of all facets in one step. Single precision, rounded outward: half the memory.
class FacetBounds {
public:
    /// Facets of the lists move from x_0 to x_1.
    void update(const FacetLists& lists, std::span<const Vec3> x_0, std::span<const Vec3> x_1);

    [[nodiscard]] const FacetBound& operator[](Index facet) const { return bound_[facet]; }

    /// Does the path pass beside the facet? With r the nodes' places at t and t + dt, seen from the
    /// path, d its way and e an edge at t, all (e × d)·r have the same sign for one of the edges.
    /// (Along the path the product is naught.) Cost: some 60 instructions.
    [[nodiscard]] bool is_passed_beside(Index facet, const Triangle& nodes,
                                        const SmallPath& path) const;

    /// Between the shares `enters` and `leaves` of the way from `from`, where the particle is at
    /// the share `now` of the step, to `to` at its end.
    [[nodiscard]] SmallPath small(const Vec3& from, const Vec3& to, double now, double enters,
                                  double leaves) const {
        SmallPath out;
        double size = size_;
        for (int a = 0; a < 3; ++a) {
            const double way = to[a] - from[a];
            const double p = from[a] + enters * way - origin_[a],
                         q = from[a] + leaves * way - origin_[a];
            out.from[a] = static_cast<float>(p);
            out.to[a] = static_cast<float>(q);
            size = std::max({size, std::abs(p), std::abs(q)});
        }
        out.after = static_cast<float>(now + enters * (1.0 - now));
        out.before = static_cast<float>(now + leaves * (1.0 - now));
        out.slack = static_cast<float>(ROUNDING * size);
        const auto high = [&](int a) { return std::max(out.from[a], out.to[a]) + out.slack; };
        const auto less = [&](int a) { return out.slack - std::min(out.from[a], out.to[a]); };
        out.box = Eight{high(0), high(1), high(2), 0.0F, less(0), less(1), less(2), 0.0F};
        return out;
    }

private:
    static constexpr double ROUNDING = 4e-6;  ///< some 60 units in the last place of a float

    Vec3 origin_ = Vec3::Zero();  ///< near the facets: small numbers are rounded less        [m]
    double size_ = 0.0;           ///< half the longest side of the grid                      [m]
    std::vector<Eight> node_;     ///< by row: x, y, z, 0 at t and at t + dt               [m]
    std::vector<FacetBound> bound_;
};

inline bool FacetBounds::is_passed_beside(Index facet, const Triangle& nodes,
                                          const SmallPath& path) const {
    using Ints = std::int32_t __attribute__((vector_size(32)));
    const auto& p = path.from;
    const Eight from{p[0], p[1], p[2], 0.0F, p[0], p[1], p[2], 0.0F};
    const Eight a = node_[nodes[0]] - from, b = node_[nodes[1]] - from, c = node_[nodes[2]] - from;
    // By component: a b c a at t, a b c a at t + dt.
    constexpr Ints LOW{0, 8, 1, 9, 4, 12, 5, 13}, HIGH{2, 10, 3, 11, 6, 14, 7, 15},
        FIRST{0, 1, 8, 9, 4, 5, 12, 13}, SECOND{2, 3, 10, 11, 6, 7, 14, 15},
        NEXT{1, 2, 0, 1, 5, 6, 4, 5};
    const Eight ab = __builtin_shuffle(a, b, LOW), ca = __builtin_shuffle(c, a, LOW);
    const Eight x = __builtin_shuffle(ab, ca, FIRST), y = __builtin_shuffle(ab, ca, SECOND),
                z = __builtin_shuffle(__builtin_shuffle(a, b, HIGH), __builtin_shuffle(c, a, HIGH),
                                      FIRST);
    const Eight along_x = __builtin_shuffle(x, NEXT) - x, along_y = __builtin_shuffle(y, NEXT) - y,
                along_z = __builtin_shuffle(z, NEXT) - z;
    const std::array<float, 3> d{path.to[0] - p[0], path.to[1] - p[1], path.to[2] - p[2]};
    const Eight n_x = along_y * d[2] - along_z * d[1], n_y = along_z * d[0] - along_x * d[2],
                n_z = along_x * d[1] - along_y * d[0];
    // |n| is at most 6 E D along all axes together, E the facet's size and D the longest component
    // of d; places are wrong by less than the slack, products of E D (D + 2 E) by some units.
    const float E = bound_[facet].size,
                D = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    const float slack = E * D * (12.0F * path.slack + 2e-6F * (D + 2.0F * E));
    const Eight above = Eight{} + slack, below = -above;
    bool is_beside = false;
    for (int e = 0; e < 3; ++e) {
        const Eight height = n_x[e] * x + n_y[e] * y + n_z[e] * z;
        is_beside |= !any_greater(above, height) | !any_greater(height, below);
    }
    return is_beside;
}

}  // namespace corpuscle::gas
