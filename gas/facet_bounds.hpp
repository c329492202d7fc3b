// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "gas/crossing.hpp"

namespace corpuscle::gas {

/// A path in single precision, as FacetBounds compare it.
struct SmallPath {
    std::array<float, 3> at_0, at_1;  ///< at t and t + dt, from the bounds' origin             [m]
    std::array<float, 3> low, high;   ///< box of the part that is asked about                  [m]
    float slack;                      ///< more than rounding can be wrong                      [m]
};

/// What a facet sweeps in one step: its box, and a plane by which most paths pass on one side.
///
/// With n the facet's unit normal at t, its nodes have the height n·x = at_0 at t and lie between low_1
/// and high_1 at t + dt. A path whose ends are both above, or both below, misses it: seen from the
/// particle, all corners of the swept facet are then on one side (crossing.hpp).
struct FacetBound {
    std::array<float, 3> low, high;     ///< box                                      [m]
    std::array<float, 3> normal;        ///< zero for a facet without area: no path is told apart
    float at_0, low_1, high_1;          ///< heights                                  [m]

    /// False only when the path misses the facet. Without branches: a wrong guess costs more.
    [[nodiscard]] bool may_meet(const SmallPath& path) const {
        bool apart = false;
        float h_0 = 0.0F, h_1 = 0.0F;
        for (int a = 0; a < 3; ++a) {
            apart |= (low[a] > path.high[a]) | (path.low[a] > high[a]);
            h_0 += normal[a] * path.at_0[a];
            h_1 += normal[a] * path.at_1[a];
        }
        apart |= (h_0 < at_0 - path.slack) & (h_1 < low_1 - path.slack);
        apart |= (h_0 > at_0 + path.slack) & (h_1 > high_1 + path.slack);
        return !apart;
    }
};

/// Bounds of all facets in one step. Single precision, rounded outward: half the memory.
class FacetBounds {
public:
    /// Facets move from x_0 to x_1. Cost: some 15 ns a facet.
    void update(std::span<const Triangle> triangles, std::span<const Vec3> x_0,
                std::span<const Vec3> x_1);

    [[nodiscard]] const FacetBound& operator[](Index facet) const { return bound_[facet]; }

    /// @param from  where the part of the path begins that is asked about; it ends at path.at_1
    [[nodiscard]] SmallPath small(const Path& path, const Vec3& from) const {
        SmallPath out;
        double size = size_;
        for (int a = 0; a < 3; ++a) {
            const double p = path.at_0[a] - origin_[a], q = path.at_1[a] - origin_[a],
                         f = from[a] - origin_[a];
            out.at_0[a] = static_cast<float>(p);
            out.at_1[a] = static_cast<float>(q);
            size = std::max({size, std::abs(p), std::abs(q)});
            out.low[a] = static_cast<float>(std::min(f, q));
            out.high[a] = static_cast<float>(std::max(f, q));
        }
        out.slack = static_cast<float>(ROUNDING * size);
        for (int a = 0; a < 3; ++a) {
            out.low[a] -= out.slack;
            out.high[a] += out.slack;
        }
        return out;
    }

private:
    static constexpr double ROUNDING = 2e-6;  ///< some 30 units in the last place of a float

    Vec3 origin_ = Vec3::Zero();  ///< near the facets: small numbers are rounded less        [m]
    double size_ = 0.0;           ///< of the facets' box                                     [m]
    std::vector<FacetBound> bound_;
};

}  // namespace corpuscle::gas
