// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// How far the nodes of patches have moved since they were marked. Bounds grow by a look at the
/// velocities in each step; what they have come to can be measured. Motion that all patches have in
/// common is left out.
class PatchMotion {
public:
    explicit PatchMotion(const Cloth& cloth);

    /// Starts at x.
    void start(const Points& x);

    /// Adds the step that was foreseen last, which led to x.
    void follow(const Points& x);

    /// Looks at the step ahead, from x to x + dt v.
    void foresee(const Points& v, double dt);

    [[nodiscard]] std::size_t size() const { return start_.size() - 1; }
    [[nodiscard]] std::span<const Index> nodes(std::integral auto patch) const {
        return std::span(node_).subspan(start_[patch], start_[patch + 1] - start_[patch]);
    }

    /// Bound of how far a patch's nodes are from where they were marked, less the motion of all; and
    /// by how much it grows in the step ahead.                                              [m]
    [[nodiscard]] double gone(Index patch) const { return gone_[patch]; }
    [[nodiscard]] double ahead(Index patch) const { return ahead_[patch]; }

    /// Mean velocity of a patch's nodes, a step before that which was foreseen last.         [m/s]
    [[nodiscard]] const Vec3& mean(Index patch) const { return from_[patch]; }
    /// How far a patch's nodes move in the step ahead, less a velocity.                      [m]
    [[nodiscard]] double ahead_from(Index patch, const Vec3& velocity) const {
        return own_[patch] + dt_ * (from_[patch] - velocity).norm();
    }

    /// Marks where all patches are.
    void mark(const Points& x);

    /// Makes the bound of a patch what it is now.
    void measure(Index patch, const Points& x);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(gone_, ahead_, own_, mean_, from_, last_, common_, common_ahead_, marked_, dt_);
    }

private:
    template <class Velocity>
    void bound(const std::vector<Index>& patches, double dt, Velocity&& velocity);

    const Cloth& cloth_;
    std::vector<Index> node_, start_;     ///< of each patch
    std::vector<Index> all_, of_bodies_;  ///< patches; those that have a rigid body's node
    std::vector<double> gone_, ahead_;    ///< by patch                                    [m]
    std::vector<double> own_;  ///< ahead, less what a patch moves in the mean              [m]
    Points mean_, from_;  ///< velocity by patch: of its nodes in the mean; seen from       [m/s]
    double dt_ = 0.0;     ///< of the step ahead; 0: none has been looked at             [s]
    Points last_;         ///< positions, of bodies' patches, N × 3     [m]
    Vec3 common_ = Vec3::Zero(), common_ahead_ = common_;  ///< of all since the mark [m]
    Points marked_;  ///< positions at the mark, N × 3              [m]
};

}  // namespace corpuscle::contact
