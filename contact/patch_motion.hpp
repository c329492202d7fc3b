// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "contact/cloth.hpp"

namespace corpuscle::contact {

/// How far patches move, as bounds that only grow: each patch as a whole against the others, and
/// its nodes against each other. Motion that all patches have in common is left out.
class PatchMotion {
public:
    explicit PatchMotion(const Cloth& cloth);

    /// Starts at x.
    void start(const Points& x) {
        last_ = x;
        dt_ = 0.0;
    }

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

    /// Bounds of the ways that a patch's nodes have gone: `drift` less the motion of all, `flutter`
    /// less the patch's own mean motion. What grows in the step ahead is apart.            [m]
    struct Ways {
        double drift = 0.0, flutter = 0.0;
    };
    [[nodiscard]] const Ways& gone(Index patch) const { return gone_[patch]; }
    [[nodiscard]] const Ways& ahead(Index patch) const { return ahead_[patch]; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(gone_, ahead_, mean_, from_, last_, dt_);
    }

private:
    template <class Velocity>
    void bound(const std::vector<Index>& patches, double dt, Velocity&& velocity);

    const Cloth& cloth_;
    std::vector<Index> node_, start_;     ///< of each patch
    std::vector<Index> all_, of_bodies_;  ///< patches; those that have a rigid body's node
    std::vector<Ways> gone_, ahead_;      ///< by patch
    Points mean_, from_;  ///< velocity by patch: of its nodes in the mean; seen from       [m/s]
    double dt_ = 0.0;     ///< of the step ahead; 0: none has been looked at             [s]
    Points last_;         ///< positions, of bodies' patches, N × 3     [m]
};

}  // namespace corpuscle::contact
