// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "contact/cards.hpp"

namespace corpuscle::contact {

/// *RIGIDWALL_PLANAR: an immovable half-space that nodes cannot enter. The impact is perfectly
/// plastic: a node that would pass in the step ahead arrives at the wall and loses its normal
/// velocity.
class PlanarWall {
public:
    explicit PlanarWall(const PlanarWallCard& card);

    /// Stops nodes, between the kick and the drift.
    ///
    ///     v_n = max(v_n, -gap / dt),   friction impulse <= mu · normal impulse (FRIC = 1: sticks)
    ///
    /// Nodes that are behind the wall when it is born are let alone until they have come out in
    /// front.
    void hold(const Points& x, std::span<const double> mass, double t, double dt, Points& v);

    /// On the wall in the last step: impulse / dt.                                              [N]
    [[nodiscard]] const Vec3& force() const { return force_; }
    /// Nodes that the last hold() stopped.
    [[nodiscard]] std::span<const Index> touching() const { return touching_; }
    [[nodiscard]] double stopping_energy() const { return stopping_energy_; }  ///< so far      [J]
    [[nodiscard]] double friction_energy() const { return friction_energy_; }  ///< so far      [J]

    /// Rows of nodes that are still behind it; known from the first hold() on.
    [[nodiscard]] std::vector<Index> nodes_behind() const;

private:
    void note_nodes_behind(const Points& x);
    [[nodiscard]] double gap(const Vec3& x) const { return card_.normal.dot(x - card_.point); }
    [[nodiscard]] Vec3 rubbed(const Vec3& v, double stop) const;

    PlanarWallCard card_;
    std::vector<std::uint8_t> is_behind_;  ///< by row in card_.nodes; empty before birth
    std::vector<Index> touching_;
    Vec3 force_ = Vec3::Zero();
    double stopping_energy_ = 0.0, friction_energy_ = 0.0;
};

}  // namespace corpuscle::contact
