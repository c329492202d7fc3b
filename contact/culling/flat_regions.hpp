// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "contact/culling/patch_motion.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// Regions of cloth, a patch and all that share a node with it, that are so flat that they cannot
/// touch themselves [Volino & Magnenat-Thalmann 1994]: seen along the region's mean normal no
/// triangle is turned over, and the rim does not cross itself. Over a point of the plane there is
/// then at most one of the region, for its number is the winding number of the rim.
///
/// Two features without a common node are at least as far apart as the least of
///
///     heights of triangles,   distances of the rim's corners from its edges
///
/// in the plane, the region's clearance: the shortest way from a node to an edge crosses a triangle
/// that has the node, or leaves the region at a node of the rim. Nodes that move by up to r against
/// one another's mean make it 2 r less, at most.
class FlatRegions {
public:
    /// @param margin  by patch: its part of the gap that matters                           [m]
    FlatRegions(const Cloth& cloth, std::span<const double> margin);

    /// Forgets which were flat.
    void start() {
        for (Region& region : regions_) region.room = 0.0;
    }
    /// Finds which regions are flat at x, and will be for a while.
    void find(const Points& x, const PatchMotion& motion);

    /// Adds the step that was foreseen last.
    void follow() {
        for (Region& region : regions_) region.used += region.ahead;
    }

    /// Whether all that were flat still are in the step ahead; looks again, at x, at those that
    /// have used up what they could bear.
    [[nodiscard]] bool hold(const Points& x, const PatchMotion& motion);

    /// Whether two patches lie in a region that is flat.
    [[nodiscard]] bool are_flat(Index p, Index q) const;

    /// Distance that features of the region round a patch keep at least, at x; 0 where it is not
    /// flat, or its rim is not one closed line.                                             [m]
    [[nodiscard]] double clearance(Index patch, const Points& x) const;

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        for (Region& region : regions_) archive(region.room, region.used, region.ahead);
    }

private:
    struct Region {
        std::vector<Index> patches, moving;  ///< that lie in it; that have triangles in it
        std::vector<Index> nodes;            ///< those of the rim first, along it
        std::vector<Triangle> triangles;     ///< rows of `nodes`
        std::size_t rim = 0;                 ///< corners; 0: it has none, or more than one
        double margin = 0.0;                 ///< the greatest of its patches'              [m]
        double room = 0.0;               ///< its nodes have against one another; 0: not flat [m]
        double used = 0.0, ahead = 0.0;  ///< of that, so far and in the step ahead      [m]
    };
    void outline(Region& region, const std::vector<Index>& patch_of, std::vector<Index>& row) const;
    void look(Index patch, const Points& x, double least_room);
    void foresee(Index patch, const PatchMotion& motion);

    const Cloth& cloth_;
    std::vector<Region> regions_;  ///< round each patch
};

}  // namespace corpuscle::contact
