// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/culling/charts.hpp"
#include "contact/culling/patch_motion.hpp"
#include "contact/culling/sheet_limits.hpp"

namespace corpuscle::contact {

/// Which patches lie open beside each other: spread so that nothing of the one can be within reach
/// of the other, as their chart tells. Looked at again only when the way of their nodes since could
/// have changed it.
class OpenCloth {
public:
    /// @param margin  by triangle: its part of the gap that matters                        [m]
    OpenCloth(const Cloth& cloth, std::span<const double> margin);

    /// Forgets what it has seen: the cloth has moved unseen.
    void forget() { limits_.forget(); }

    /// Leaves out the pairs of patches p <= q that lie open at x.
    void drop_open(const Points& x, PatchMotion& motion,
                   std::vector<std::pair<Index, Index>>& pairs);

    /// Whether those that were left out lie open in the step ahead of x, too.
    [[nodiscard]] bool holds(const Points& x, PatchMotion& motion);

    /// How far nodes may move until patches p <= q may not lie open any more, looked at anew: a
    /// number below 0 where they do not, INF where they have no chart.                      [m]
    [[nodiscard]] double spare(Index p, Index q, const Points& x) const;

    /// That of a pair that was left out, as the last looks and the way since have it: never more.
    [[nodiscard]] double known_spare(Index p, Index q, const PatchMotion& motion) const;

    /// Whether patches p <= q lie beside each other in a chart.
    [[nodiscard]] bool are_neighbours(Index p, Index q) const {
        return charts_.link(p, q).chart >= 0;
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(limits_, least_limit_, used_, pause_);
    }

private:
    [[nodiscard]] bool has_turned(Index c) const {
        return std::find(turned_.begin(), turned_.end(), c) != turned_.end();
    }
    void look_at_patches(std::span<const Index> patches, const std::vector<std::uint64_t>& wanted,
                         const Points& x, PatchMotion& motion);
    void look_at_charts(const Points& x, PatchMotion& motion);
    template <class IsDue>
    void list_due(IsDue&& is_due, const Points& x, PatchMotion& motion);
    void mark_sheets(const std::vector<std::uint64_t>& wanted, const Points& x,
                     PatchMotion& motion);
    void find_least_limit(Index patch);

    Charts charts_;
    SheetLimits limits_;
    std::vector<double> least_limit_;  ///< by patch, of the sheets that count          [m]
    std::vector<std::uint64_t> used_;  ///< by chart: sheets that pairs left out lie on
    std::vector<std::uint8_t> pause_;  ///< by chart: calls for which it is not looked at
    double spare_;                     ///< way left to what is left out                    [m]

    std::vector<std::uint64_t> wanted_;  ///< by chart: sheets that pairs at hand lie on
    std::vector<Index> due_;             ///< patches
    std::vector<Index> turned_;          ///< charts, in this step
    std::vector<std::uint8_t> is_due_;   ///< patches
};

}  // namespace corpuscle::contact
