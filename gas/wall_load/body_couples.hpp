// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>
#include <vector>

#include "gas/enclosure/wetted_surface.hpp"
#include "gas/wall_load/rigid_field.hpp"

namespace corpuscle::gas {

/// Couples by which hits turn a rigid body as they would have at their own time and place.
///
/// A hit J at y reaches the body with the next kick, at nodes that have moved on to x_p, each with
/// its share J_p: what is missing of its moment,
///
///     C = sum y × J - sum x_p × J_p,
///
/// half a step's turning on average, is given in the same kick, as impulses without a sum over the
/// body's points of the hit's room (RigidField, by area). So gas and body together keep their
/// angular momentum about any place that rests, to rounding. Points on a line bear no couple: what
/// it should be is then kept as owed.
class BodyCouples {
public:
    /// @param body  N: row of the rigid body that a node rides on, where that body can turn, or -1;
    ///              empty: there is none
    BodyCouples(const WettedSurface& surface, std::span<const Index> body);

    /// Does a body carry the point?
    [[nodiscard]] bool carries(Index point) const { return !group_.empty() && group_[point] >= 0; }
    /// Does a body carry one of a side's points?
    [[nodiscard]] bool carries_any(const std::array<Index, 3>& points) const {
        return carries(points[0]) || carries(points[1]) || carries(points[2]);
    }
    /// Does one body carry them all?
    [[nodiscard]] bool carries_all(const std::array<Index, 3>& points) const {
        return carries(points[0]) && group_[points[0]] == group_[points[1]] &&
               group_[points[0]] == group_[points[2]];
    }

    /// A point that a body carries gets an impulse [N s] of a hit, whose place [m] this is. Points
    /// that no body carries may be told.
    void take(Index point, const Vec3& place, const Vec3& impulse) {
        if (carries(point)) moment_[point] += place.cross(impulse);
    }

    /// Adds the couples of all that was taken since the last call to the forces by which it is given.
    /// @param x      N × 3, now                                                          [m]
    /// @param area   by point                                                          [m^2]
    /// @param force  by point                                                            [N]
    void give(double span, const WettedSurface& surface, std::span<const Vec3> x,
              std::span<const double> area, std::span<Vec3> force);

    /// What points on a line could not bear.                                         [N m s]
    [[nodiscard]] Vec3 owed() const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(moment_, owed_);
    }

private:
    std::vector<Index> group_;           ///< by point: body and room, or -1; empty: no body
    std::vector<Index> start_, points_;  ///< of each group, compressed rows
    Points moment_;                      ///< by point, about the origin                 [N m s]
    Points owed_;                        ///< by group                                   [N m s]
};

}  // namespace corpuscle::gas
