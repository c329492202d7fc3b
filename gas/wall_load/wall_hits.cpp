// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/wall_hits.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t LISTS_AT_ONCE = 2;
constexpr std::size_t GROUPS = 16;      ///< of hits that are counted and sorted together
constexpr std::size_t LEAST_HITS = 64;  ///< of a group at least

/// Where hit k of a list is the last of a particle, the number of its hits; else 0.
Index settles(const std::vector<Hit>& hits, std::size_t k) {
    const Index who = hits[k].who;
    if (k + 1 < hits.size() && hits[k + 1].who == who) return 0;
    std::size_t begin = k;
    while (begin > 0 && hits[begin - 1].who == who) --begin;
    return static_cast<Index>(k + 1 - begin);
}

}  // namespace

void WallHits::list(FlightResult& flight, std::span<const Vec3> x_0, std::span<const Vec3> x_1) {
    x_0_ = x_0;
    x_1_ = x_1;
    first_.resize(flight.hits.size() + 1);
    first_[0] = 0;
    for (std::size_t l = 0; l < flight.hits.size(); ++l)
        first_[l + 1] = first_[l] + flight.hits[l].size();
    sides_.resize(first_.back());
    by_patch_.resize(first_.back());
    const std::size_t hits_a_group = std::max(LEAST_HITS, (sides_.size() + GROUPS - 1) / GROUPS);
    const std::size_t groups = parallel::chunk_count(sides_.size(), hits_a_group);
    count_.resize(groups * patches_.size());
    const auto patch = [&](std::size_t i) { return patches_.of(sides_[i]); };
    const auto find_sides = [&](std::size_t l) {
        const std::vector<Hit>& hits = flight.hits[l];
        for (std::size_t k = 0; k < hits.size(); ++k)
            sides_[first_[l] + k] = static_cast<Index>(side_of(hits[k], x_0, x_1));
    };
    const auto end_of = [&](std::size_t g) {
        return std::min(sides_.size(), (g + 1) * hits_a_group);
    };
    const auto count_group = [&](std::size_t g) {
        std::uint32_t* const count = count_.data() + g * patches_.size();
        std::fill(count, count + patches_.size(), 0);
        for (std::size_t i = g * hits_a_group; i < end_of(g); ++i) ++count[patch(i)];
    };
    const auto share_out = [&] { find_starts(groups); };
    const auto sort_group = [&](std::size_t g) {
        std::uint32_t* const next = count_.data() + g * patches_.size();
        std::size_t i = g * hits_a_group;
        auto l = static_cast<std::size_t>(std::upper_bound(first_.begin(), first_.end(), i) -
                                          first_.begin() - 1);
        for (; i < end_of(g); ++i) {
            while (i >= first_[l + 1]) ++l;
            std::vector<Hit>& hits = flight.hits[l];
            const std::size_t k = i - first_[l];
            by_patch_[start_[patch(i)] + next[patch(i)]++] = {&hits[k], sides_[i],
                                                              settles(hits, k)};
        }
    };
    parallel::in_turn(parallel::each(flight.hits.size(), find_sides, LISTS_AT_ONCE),
                      parallel::each(groups, count_group, 1), parallel::alone(share_out),
                      parallel::each(groups, sort_group, 1));
}

/// Where hits of each patch begin, and within it those of each group.
void WallHits::find_starts(std::size_t groups) {
    const std::size_t rows = patches_.size();
    sum_.assign(rows, 0);
    for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t row = 0; row < rows; ++row) {
            const std::uint32_t own = count_[g * rows + row];
            count_[g * rows + row] = sum_[row];
            sum_[row] += own;
        }
    start_.resize(rows + 1);
    start_[0] = 0;
    for (std::size_t row = 0; row < rows; ++row) start_[row + 1] = start_[row] + sum_[row];
}

/// On which side a facet was hit: gas pushes away from itself.
std::size_t WallHits::side_of(const Hit& hit, std::span<const Vec3> x_0,
                              std::span<const Vec3> x_1) const {
    const auto facet = static_cast<std::size_t>(hit.facet);
    if (surface_.closes(facet)) return surface_.side(facet, false);
    std::array<Vec3, 3> x;
    for (int c = 0; c < 3; ++c) {
        const Index n = surface_.triangles()[facet][c];
        x[c] = 0.5 * (x_0[n] + x_1[n]);
    }
    return surface_.side(facet, hit.impulse.dot(vector_area(x[0], x[1], x[2])) < 0.0);
}

std::array<Vec3, 3> WallHits::corners(const Hit& hit) const {
    std::array<Vec3, 3> x;
    Vec3 off = hit.where;
    for (int c = 0; c < 3; ++c) {
        const Index n = surface_.triangles()[static_cast<std::size_t>(hit.facet)][c];
        x[c] = 0.5 * (x_0_[n] + x_1_[n]);
        off -= hit.at[c] * x[c];
    }
    for (Vec3& corner : x) corner += off;
    return x;
}

}  // namespace corpuscle::gas
