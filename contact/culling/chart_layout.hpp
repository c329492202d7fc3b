// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "contact/culling/convex_region.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// By edge of the cloth: its two triangles; -1 where it has fewer, or more.
using EdgeSides = std::vector<std::array<Index, 2>>;
[[nodiscard]] EdgeSides sides_of_edges(const Cloth& cloth);

/// The cloth round one patch, in the plane: the reference shape seen along the patch's mean normal.
class ChartLayout {
public:
    ChartLayout(const Cloth& cloth, const EdgeSides& sides, Index patch);

    /// Directions of the plane, k = 0, 1.                                                   [-]
    [[nodiscard]] Vec3 axis(int k) const { return axes_.col(k); }

    /// Whether two patches are too near for being told apart by their places.
    [[nodiscard]] bool are_near(Index p, Index q);

    /// A triangle's least height in the plane.                                              [m]
    [[nodiscard]] double least_height(Index triangle) const;

    /// Triangles that lie on the straight ways between all places of two patches, if these make up
    /// one sheet of cloth that covers all such ways just once: across each edge that a way crosses
    /// lies one neighbour, beyond it; and the parts that lie between the patches are as large
    /// together as what they cover.
    [[nodiscard]] std::optional<std::vector<Index>> between(Index p, Index q);

private:
    [[nodiscard]] Vec2 at(Index node) const {
        return axes_.transpose() * (cloth_.reference_x[node] - centre_);
    }
    [[nodiscard]] std::array<Vec2, 3> corners(Index triangle) const {
        const auto& [a, b, c] = cloth_.triangles[triangle];
        return {at(a), at(b), at(c)};
    }
    const std::vector<Vec2>& points(Index patch);
    [[nodiscard]] bool is_flat_enough(Index triangle, const std::array<Vec2, 3>& u) const;
    [[nodiscard]] Index beyond(Index triangle, std::size_t k, const std::array<Vec2, 3>& u) const;

    const Cloth& cloth_;
    const EdgeSides& sides_;
    Eigen::Matrix<double, 3, 2> axes_;
    Vec3 centre_ = Vec3::Zero();
    std::map<Index, std::vector<Vec2>> points_;  ///< by patch: its nodes                    [m]
    std::vector<Index> met_;                     ///< by triangle: try in which it was found
    Index tried_ = 0;
};

}  // namespace corpuscle::contact
