// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/body_couples.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Of its size³, below which points lie on a line. A body is stiff: it matters little where on a
/// slender one the couple acts.
constexpr double SLENDER = 1e-9;

/// What the points of a group can bear, and what is missing.
struct CoupleSums {
    Lever lever;
    Vec3 missing = Vec3::Zero();  ///< [N m s]
    CoupleSums& operator+=(const CoupleSums& o) {
        lever += o.lever;
        missing += o.missing;
        return *this;
    }
};

}  // namespace

BodyCouples::BodyCouples(const WettedSurface& surface, std::span<const Index> body) {
    std::map<std::pair<Index, Index>, Index> group_of;  // body and room
    const auto key = [&](std::size_t p) {
        return std::pair(body[surface.node(p)], surface.room_of_point(p));
    };
    for (std::size_t p = 0; p < surface.points() && !body.empty(); ++p)
        if (body[surface.node(p)] >= 0) group_of.emplace(key(p), 0);
    if (group_of.empty()) return;
    Index groups = 0;
    for (auto& [of, group] : group_of) group = groups++;
    start_.assign(group_of.size() + 1, 0);
    for (std::size_t p = 0; p < surface.points(); ++p) {
        const auto found = group_of.find(key(p));
        group_.push_back(found == group_of.end() ? -1 : found->second);
        if (group_[p] < 0) continue;
        points_.push_back(static_cast<Index>(p));
        ++start_[group_[p] + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::stable_sort(points_.begin(), points_.end(),
                     [&](Index a, Index b) { return group_[a] < group_[b]; });
    moment_.assign(surface.points(), Vec3::Zero());
    owed_.assign(group_of.size(), Vec3::Zero());
}

void BodyCouples::give(double span, const WettedSurface& surface, std::span<const Vec3> x,
                       std::span<const double> area, std::span<Vec3> force) {
    for (std::size_t g = 0; g < owed_.size(); ++g) {
        const auto points = std::span(points_).subspan(start_[g], start_[g + 1] - start_[g]);
        const Vec3 origin = x[surface.node(points[0])];
        const CoupleSums sums = parallel::sum(points.size(), CoupleSums{}, [&](std::size_t k) {
            const Index p = points[k];
            const Vec3& at = x[surface.node(p)];
            CoupleSums own;
            own.lever.add(area[p], at - origin);
            own.missing = moment_[p] - at.cross(span * force[p]);
            moment_[p].setZero();
            return own;
        });
        owed_[g] += sums.missing;
        if (!(sums.lever.weight > 0.0)) continue;
        const RigidField couple(sums.lever, origin, {Vec3::Zero(), owed_[g]}, SLENDER);
        owed_[g] -= couple.whole().angular;
        parallel::for_each(points.size(), [&](std::size_t k) {
            const Index p = points[k];
            force[p] += area[p] / span * couple.at(x[surface.node(p)]);
        });
    }
}

Vec3 BodyCouples::owed() const {
    return std::accumulate(owed_.begin(), owed_.end(), Vec3(Vec3::Zero()));
}

}  // namespace corpuscle::gas
