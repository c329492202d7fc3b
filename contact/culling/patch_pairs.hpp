// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "contact/broad_phase/broad_phase.hpp"
#include "contact/culling/flat_regions.hpp"
#include "contact/culling/patch_motion.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

/// Two patches p <= q of the cloth, or twice the same.
using PatchPair = std::pair<Index, Index>;

/// Patches, with their nodes and triangles, all ascending.
struct Pieces {
    std::vector<Index> patches, nodes, triangles;

    /// Makes it what some pairs of patches consist of.
    void list(const Cloth& cloth, const PatchMotion& motion, std::span<const PatchPair> pairs);

private:
    std::vector<std::uint8_t> is_met_;  ///< patches, nodes, or triangles
    parallel::Gathered<Index> met_;
};

/// Which patches of cloth have to be searched: FCL tells whose boxes overlap, each with room to
/// move; those of them between which there is a plane, or that lie in one flat region, are left out.
/// Holds until a patch has used up its room, or a region is flat no more.
class PatchPairs {
public:
    /// @param margin  by triangle: its part of the gap that matters                        [m]
    PatchPairs(const Cloth& cloth, std::span<const double> margin);

    /// Begins at x.
    void start(const Points& x) { motion_.start(x), regions_.start(); }
    void follow(const Points& x) {
        motion_.follow(x);
        regions_.follow();
    }

    /// Looks at the step ahead, from x to x + dt v.
    void foresee(const Points& v, double dt) { motion_.foresee(v, dt); }

    /// Whether what was found holds in that step, too.
    [[nodiscard]] bool holds(const Points& x);

    /// Finds them anew, with room for so many steps like the one that was foreseen.
    void find(const Points& x, double steps);

    /// Pairs p <= q that may meet, sorted; each patch also with itself.
    [[nodiscard]] std::span<const PatchPair> pairs() const { return pairs_; }
    /// What these are of.
    [[nodiscard]] const Pieces& pieces() const { return pieces_; }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(motion_, regions_, room_, pairs_, pieces_.patches, pieces_.nodes,
                pieces_.triangles);
    }

private:
    [[nodiscard]] bool may_touch(Index p, Index q) const;
    [[nodiscard]] bool are_apart(Index p, Index q, const Points& x) const;
    [[nodiscard]] const Vec3& farthest(Index patch, const Vec3& along, const Points& x) const;
    void drop_apart(const Points& x);
    void find_pairs();

    const Cloth& cloth_;
    PatchMotion motion_;
    std::vector<Index> part_, body_;  ///< that a whole patch is of, or -1
    std::vector<double> margin_;      ///< by patch                                        [m]
    std::vector<double> room_;        ///< by patch: drift that it has room for            [m]
    FlatRegions regions_;
    BroadPhase tree_;
    parallel::Gathered<PatchPair> found_pairs_;
    std::vector<Box> box_;
    Points middle_;  ///< by patch                                                          [m]
    std::vector<PatchPair> pairs_;
    Pieces pieces_;
    std::vector<std::uint8_t> is_met_;  ///< by pair
};

}  // namespace corpuscle::contact
