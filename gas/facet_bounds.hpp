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
    std::vector<Quad> small_0_, small_1_;  ///< by node row                              [m]
    std::vector<FacetBound> bound_;
};

}  // namespace corpuscle::gas
