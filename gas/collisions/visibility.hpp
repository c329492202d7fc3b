// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

/// A facet that may stand between two particles. All tests err on the side of "it does": what
/// touches, or is too close to tell, is in the way.
class Screen {
public:
    /// @param reach  no point asked about is farther than this from the facet's box      [m]
    Screen(const Vec3& a, const Vec3& b, const Vec3& c, double reach)
        : a_(a), b_(b), c_(c), normal_((b - a).cross(c - a)) {
        const double longest2 =
            std::max({(b - a).squaredNorm(), (c - a).squaredNorm(), (c - b).squaredNorm()});
        const double longest = std::sqrt(longest2);
        plane_slack_ = CLOSE * reach * normal_.norm() + ROUNDING * longest2 * (longest + reach);
        edge_slack_ = CLOSE * reach * longest + ROUNDING * (longest + reach) * (longest + reach);
    }

    /// On which side of the facet's plane: -1, +1; 0 where it cannot be told.
    [[nodiscard]] int side(const Vec3& p) const {
        const double height = normal_.dot(p - a_);
        return height > plane_slack_ ? 1 : height < -plane_slack_ ? -1 : 0;
    }

    /// May the line through p and q, known to meet the plane between them, pass through the facet?
    /// By the signs of the volumes that it spans with the three edges. Cost: 3 cross products.
    [[nodiscard]] bool blocks(const Vec3& p, const Vec3& q) const {
        const Vec3 d = q - p, a = a_ - p, b = b_ - p, c = c_ - p;
        const double ab = d.dot(a.cross(b)), bc = d.dot(b.cross(c)), ca = d.dot(c.cross(a));
        const double slack = edge_slack_ * d.norm();
        return std::min({ab, bc, ca}) >= -slack || std::max({ab, bc, ca}) <= slack;
    }

private:
    static constexpr double CLOSE = 1e-9;      ///< of the reach: nearer than this is touching
    static constexpr double ROUNDING = 8e-15;  ///< covers the rounding of the products above

    Vec3 a_, b_, c_;
    Vec3 normal_;         ///< not normalised
    double plane_slack_;  ///< [m^3]
    double edge_slack_;   ///< [m^2]
};

}  // namespace corpuscle::gas
