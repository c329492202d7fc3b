// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "io/deck/faults.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// A row of *DEFINE_TRANSFORMATION.
struct TransformationStep {
    enum class Kind : std::uint8_t {
        FIXED,               ///< `map`: TRANSL, SCALE, MIRROR, ROTATE about a written axis
        ROTATE_BY_POINTS,    ///< about the line from point 0 to 1 by `amount`
        ROTATE_BY_NODES,     ///< along node 0 to 1, through node 2, by `amount`
        TRANSLATE_BY_NODES,  ///< from node 0 towards node 1 by `amount`, 0: as far as it is
        SIX_POINTS,          ///< points 0 to 2 onto 3 to 5
        SIX_NODES            ///< nodes 0 to 2 onto 3 to 5
    };
    Kind kind = Kind::FIXED;
    Eigen::Affine3d map = Eigen::Affine3d::Identity();
    std::array<Vec3, 6> points{};  ///< of POINT rows, as written
    std::array<Index, 6> nodes{-1, -1, -1, -1, -1, -1};
    double amount = 0.0;  ///< an angle [rad], or a length [m]
    Place place;
};

/// Place of a node before a transformation moves it on. `so_far`: what its rows before have made of
/// what it moves.
using NodePlace = std::function<Vec3(Index node, const Eigen::Affine3d& so_far)>;

/// *DEFINE_TRANSFORMATION: its rows act in their order, the first one first.
struct Transformation {
    int id = 0;
    std::vector<TransformationStep> steps;

    /// Is it known without the places of nodes?
    [[nodiscard]] bool needs_nodes() const;
    /// x' = map x. Nodes in line, where a row needs a plane or an axis, are faults.
    [[nodiscard]] Eigen::Affine3d map(const NodePlace& place_of, Faults& faults) const;
};

/// The rigid motion that takes a to d, the line a-b onto d-e and the plane a-b-c onto d-e-f.
[[nodiscard]] Eigen::Affine3d six_points(const std::array<Vec3, 6>& points);

/// Do three places span a plane?
[[nodiscard]] bool spans_plane(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace corpuscle::io
