// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Of a closed surface as a point sees it [van Oosterom & Strackee 1983, Eq. 8]: 4 pi inside, 2 pi
/// on one of its facets. Normals lead outward.                                             [sr]
[[nodiscard]] double solid_angle(std::span<const Triangle> wall, const Vec3& point,
                                 std::span<const Vec3> x);

/// Whether a point lies inside, by that angle: on the surface it does not. Cost: one atan2 a facet.
[[nodiscard]] inline bool holds(std::span<const Triangle> wall, const Vec3& point,
                                std::span<const Vec3> x) {
    return solid_angle(wall, point, x) > 3.0 * std::numbers::pi;
}

/// How often a closed surface at rest goes round a point, for many points.
///
/// A ray from the point along the surface's shortest extent counts the facets that it passes, each
/// +1 from inside out and -1 the other way. Facets are sorted into columns, so a point asks only
/// those of its own. Edges that two facets share are decided by one number for both, so no ray
/// slips between them.
class InsideTest {
public:
    /// @param outward  a closed surface, normals outward
    InsideTest(std::span<const Triangle> outward, std::span<const Vec3> x);

    /// 0 outside, 1 inside, more where the surface overlaps itself; none for a point so near a
    /// facet that rounding would decide.
    [[nodiscard]] std::optional<int> winding(const Vec3& point) const;

    [[nodiscard]] const Vec3& low() const { return low_; }  ///< corners of the surface's box [m]
    [[nodiscard]] const Vec3& high() const { return high_; }

private:
    struct Facet {
        std::array<double, 3> a, b, c;  ///< corners, the ray's axis last
        std::array<Index, 3> node;
    };
    [[nodiscard]] std::size_t along(int axis, double at) const;

    std::array<int, 3> axis_{};  ///< of the columns' plane, and of the ray
    Vec3 low_, high_;
    std::array<std::size_t, 2> columns_{};
    std::vector<Facet> facets_;
    std::vector<Index> start_, in_;  ///< column -> facets, compressed rows
    double near_ = 0.0;              ///< [m]
};

}  // namespace corpuscle::gas
