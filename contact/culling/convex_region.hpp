// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include <Eigen/Core>

namespace corpuscle::contact {

using Vec2 = Eigen::Vector2d;

/// The convex hull of points in a plane.                                                    [m]
class ConvexRegion {
public:
    explicit ConvexRegion(std::vector<Vec2> points);

    [[nodiscard]] double area() const { return area_; }  ///< [m²]

    enum class Part { NONE, SOME, ALL };
    /// Of a triangle, how much lies within; SOME where that is not plain to see.
    [[nodiscard]] Part part_within(const std::array<Vec2, 3>& triangle) const;
    /// Of the part of a triangle that lies within.                                        [m²]
    [[nodiscard]] double area_within(const std::array<Vec2, 3>& triangle) const;
    /// Whether a part of the way from a to b lies within, not only along the border.
    [[nodiscard]] bool is_crossed(const Vec2& a, const Vec2& b) const;

private:
    /// How far p is within border k.                                                       [m]
    [[nodiscard]] double depth(std::size_t k, const Vec2& p) const {
        return inward_[k].dot(p) - offset_[k];
    }

    std::vector<Vec2> corner_;  ///< counter-clockwise
    std::vector<Vec2> inward_;  ///< unit normals of the borders k -> k + 1
    std::vector<double> offset_;
    double area_ = 0.0, border_ = 0.0;  ///< width of what counts as the border               [m]
};

}  // namespace corpuscle::contact
