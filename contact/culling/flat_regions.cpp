// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/culling/flat_regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/culling/rim.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/sorted.hpp"

namespace corpuscle::contact {
namespace {

constexpr std::size_t MOST_PATCHES = 32;  ///< of a region: round a hub all cloth meets
constexpr int ROUNDS = 4;                 ///< of closing gaps in a rim
/// Room from which a region counts as flat, in edge lengths and in steps: with less it would not be
/// for long, and then all is listed anew.
constexpr double FLAT_ROOM = 0.1, FLAT_STEPS = 2.0;
constexpr std::size_t REGIONS_A_CHUNK = 4;
constexpr float PLANE_ROUNDING = 8.0F * std::numeric_limits<float>::epsilon();  ///< of its size

}  // namespace

FlatRegions::FlatRegions(const Cloth& cloth, std::span<const double> margin)
    : cloth_(cloth), regions_(cloth.patches.size()) {
    std::vector<Index> patch_of(cloth.triangles.size()), row(cloth.inverse_mass.size(), -1);
    for (std::size_t p = 0; p < regions_.size(); ++p)
        for (const Index t : cloth.patches[p]) patch_of[t] = static_cast<Index>(p);
    for (std::size_t p = 0; p < regions_.size(); ++p) {
        Region& region = regions_[p];
        for (const Index t : cloth.patches[p])
            for (const Index n : cloth.triangles[t])
                for (const Index other : cloth.triangles_of(n))
                    region.patches.push_back(patch_of[other]);
        sort_unique(region.patches);
        for (const Index q : region.patches) region.margin = std::max(region.margin, margin[q]);
        if (region.patches.size() <= MOST_PATCHES) outline(region, patch_of, row);
    }
}

/// Its triangles and its rim. Patches are ragged: where two corners of the rim are one, all triangles
/// there are taken in. None of rigid bodies, for these turn.
void FlatRegions::outline(Region& region, const std::vector<Index>& patch_of,
                          std::vector<Index>& row) const {
    std::vector<Index> rows, forks;
    for (const Index p : region.patches)
        rows.insert(rows.end(), cloth_.patches[p].begin(), cloth_.patches[p].end());
    for (int round = 0; round < ROUNDS; ++round) {
        sort_unique(rows);
        region.triangles.clear();
        for (const Index t : rows) region.triangles.push_back(cloth_.triangles[t]);
        region.nodes = rim_of(region.triangles, forks);
        if (forks.empty()) break;
        for (const Index n : forks)
            for (const Index t : cloth_.triangles_of(n)) rows.push_back(t);
    }
    for (const Index t : rows) region.moving.push_back(patch_of[t]);
    sort_unique(region.moving);
    const auto has_body = [&](const Triangle& t) {
        return std::any_of(t.begin(), t.end(), [&](Index n) { return cloth_.body[n] >= 0; });
    };
    if (!std::any_of(region.triangles.begin(), region.triangles.end(), has_body))
        region.rim = region.nodes.size();
    for (std::size_t i = 0; i < region.nodes.size(); ++i)
        row[region.nodes[i]] = static_cast<Index>(i);
    for (Triangle& t : region.triangles)
        for (Index& n : t) {
            if (row[n] < 0) {
                row[n] = static_cast<Index>(region.nodes.size());
                region.nodes.push_back(n);
            }
            n = row[n];
        }
    for (const Index n : region.nodes) row[n] = -1;
}

double FlatRegions::clearance(Index patch, const Points& x) const {
    const Region& region = regions_[patch];
    if (region.rim == 0) return 0.0;
    const Vec3 from = x[region.nodes[0]];
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < region.rim; ++i)
        normal += (x[region.nodes[i]] - from).cross(x[region.nodes[i + 1]] - from);
    if (!(normal.squaredNorm() > 0.0)) return 0.0;
    const Vec3 across = normal.unitOrthogonal(), up = normal.normalized().cross(across);

    thread_local PlanePoints at;
    at.x.resize(region.nodes.size());
    at.y.resize(region.nodes.size());
    float size = 0.0F;
    for (std::size_t i = 0; i < region.nodes.size(); ++i) {
        const Vec3 off = x[region.nodes[i]] - from;
        at.x[i] = static_cast<float>(off.dot(across));
        at.y[i] = static_cast<float>(off.dot(up));
        size = std::max({size, std::abs(at.x[i]), std::abs(at.y[i])});
    }
    const float heights = least_height_square(at, region.triangles);
    if (!(heights > 0.0F)) return 0.0;
    const float square = rim_distance_square(at, region.rim, heights);
    return std::max(0.0F, std::sqrt(square) - PLANE_ROUNDING * size);
}

/// @param least_room  less is not flat                                                   [m]
void FlatRegions::look(Index patch, const Points& x, double least_room) {
    Region& region = regions_[patch];
    region.used = 0.0;
    region.room = 0.5 * clearance(patch, x) - region.margin;
    if (!(region.room > least_room)) region.room = 0.0;
}

/// How far nodes of a region move in the step ahead, less the mean of the patch in its middle.
void FlatRegions::foresee(Index patch, const PatchMotion& motion) {
    Region& region = regions_[patch];
    region.ahead = 0.0;
    for (const Index q : region.moving)
        region.ahead = std::max(region.ahead, motion.ahead_from(q, motion.mean(patch)));
}

void FlatRegions::find(const Points& x, const PatchMotion& motion) {
    const auto one = [&](std::size_t i) {
        const auto p = static_cast<Index>(i);
        foresee(p, motion);
        const double soon = FLAT_STEPS * regions_[i].ahead;
        if (!(regions_[i].used + soon < regions_[i].room))
            look(p, x, std::max(FLAT_ROOM * cloth_.mean_edge, soon));
    };
    parallel::for_each(regions_.size(), one, REGIONS_A_CHUNK);
}

bool FlatRegions::hold(const Points& x, const PatchMotion& motion) {
    const auto is_lost = [&](std::size_t i) -> std::size_t {
        const auto p = static_cast<Index>(i);
        Region& region = regions_[i];
        if (region.room == 0.0) return 0;
        foresee(p, motion);
        if (region.used + region.ahead > region.room) look(p, x, region.ahead);
        return region.room == 0.0 ? 1 : 0;
    };
    return parallel::sum(regions_.size(), std::size_t{0}, is_lost, REGIONS_A_CHUNK) == 0;
}

bool FlatRegions::are_flat(Index p, Index q) const {
    const auto holds_q = [&](Index r) {
        const std::vector<Index>& patches = regions_[r].patches;
        return regions_[r].room > 0.0 && std::binary_search(patches.begin(), patches.end(), q);
    };
    const std::vector<Index>& mine = regions_[p].patches;
    return std::any_of(mine.begin(), mine.end(), holds_q);
}

}  // namespace corpuscle::contact
