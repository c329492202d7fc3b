// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// How far patches have moved: each as a whole against the others since all were marked, and the
/// corners of its triangles against each other. Bounds grow by a look at the velocities in each
/// step; what they have come to can be measured. Motion that all patches have in common is left
/// out.
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
    [[nodiscard]] std::span<const Index> nodes(Index patch) const {
        return std::span(node_).subspan(start_[patch], start_[patch + 1] - start_[patch]);
    }
    [[nodiscard]] std::span<const Index> nodes(std::size_t patch) const {
        return nodes(static_cast<Index>(patch));
    }

    /// Bounds of a patch's motion: `drift`, of how far its nodes are from where they were marked,
    /// less the motion of all; `flutter` grows by at least half the way of two corners of a
    /// triangle against each other, from any time to any later one. What grows in the step ahead
    /// is apart.                                                                           [m]
    struct Ways {
        double drift = 0.0, flutter = 0.0;
    };
    [[nodiscard]] const Ways& gone(Index patch) const { return gone_[patch]; }
    [[nodiscard]] const Ways& ahead(Index patch) const { return ahead_[patch]; }

    /// Marks where all patches are, for their drift.
    void mark(const Points& x);

    /// Makes the drift of a patch what it is now.
    void measure_drift(Index patch, const Points& x);

    /// Lowers the flutter of a patch to what it was when its shape was marked, and what its
    /// triangles have come to since. It grows from times up to that mark, but not from those
    /// between: whatever is to be compared with later flutter starts with a mark.
    void measure_flutter(Index patch, const Points& x);

    /// Measures it and marks the shape of the patch.
    void mark_shape(Index patch, const Points& x);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(gone_, ahead_, mean_, from_, last_, common_, common_ahead_, marked_, shape_,
                shape_flutter_, dt_);
    }

private:
    void list_edges(std::size_t patch);
    template <class Velocity>
    void bound(const std::vector<Index>& patches, double dt, Velocity&& velocity);

    const Cloth& cloth_;
    std::vector<Index> node_, start_;                          ///< of each patch
    std::vector<std::pair<std::uint8_t, std::uint8_t>> edge_;  ///< of each: two of its nodes
    std::vector<Index> edge_start_;
    std::vector<Index> all_, of_bodies_;  ///< patches; those that have a rigid body's node
    std::vector<Ways> gone_, ahead_;      ///< by patch
    Points mean_, from_;  ///< velocity by patch: of its nodes in the mean; seen from       [m/s]
    double dt_ = 0.0;     ///< of the step ahead; 0: none has been looked at             [s]
    Points last_;         ///< positions, of bodies' patches, N × 3     [m]
    Vec3 common_ = Vec3::Zero(), common_ahead_ = common_;  ///< way of all since the mark [m]
    Points marked_;                      ///< positions at the mark, N × 3              [m]
    Points shape_;                       ///< of patches' nodes at their marks          [m]
    std::vector<double> shape_flutter_;  ///< by patch, at its mark                     [m]
};

}  // namespace corpuscle::contact
