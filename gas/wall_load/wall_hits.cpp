// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/wall_hits.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t HIT_LISTS_A_CHUNK = 8;

}  // namespace

void WallHits::list(FlightResult& flight, std::span<const Vec3> x_0, std::span<const Vec3> x_1) {
    first_.resize(flight.hits.size() + 1);
    first_[0] = 0;
    for (std::size_t l = 0; l < flight.hits.size(); ++l)
        first_[l + 1] = first_[l] + flight.hits[l].size();
    sides_.resize(first_.back());
    patch_.resize(first_.back());
    parallel::for_each(
        flight.hits.size(),
        [&](std::size_t l) {
            const std::vector<Hit>& hits = flight.hits[l];
            for (std::size_t k = 0; k < hits.size(); ++k)
                sides_[first_[l] + k] = static_cast<Index>(side_of(hits[k], x_0, x_1));
            find_patches(hits, first_[l]);
        },
        HIT_LISTS_A_CHUNK);
    sort(flight);
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

/// Row of start_ of a particle's hits.
Index WallHits::patch_of(std::span<const Index> sides) const {
    const auto common = [&](const SidePatches& patches) {
        const Index patch = patches.of(static_cast<std::size_t>(sides[0]));
        return std::all_of(
                   sides.begin() + 1, sides.end(),
                   [&](Index side) { return patches.of(static_cast<std::size_t>(side)) == patch; })
                   ? patch
                   : -1;
    };
    const auto scattered = static_cast<Index>(patches_.size());
    if (const Index patch = common(patches_); patch >= 0) return patch;
    if (const Index patch = common(wide_); patch >= 0) return scattered + patch;
    return scattered + static_cast<Index>(wide_.size());
}

/// @param first  of the list, among all
void WallHits::find_patches(const std::vector<Hit>& hits, std::size_t first) {
    for (std::size_t begin = 0, end = 0; begin < hits.size(); begin = end) {
        while (end < hits.size() && hits[end].who == hits[begin].who) ++end;
        const Index patch = patch_of(std::span(sides_).subspan(first + begin, end - begin));
        std::fill(patch_.begin() + static_cast<std::ptrdiff_t>(first + begin),
                  patch_.begin() + static_cast<std::ptrdiff_t>(first + end), patch);
    }
}

/// By counting.
void WallHits::sort(FlightResult& flight) {
    start_.assign(patches_.size() + wide_.size() + 3, 0);
    for (const Index patch : patch_) ++start_[patch + 2];
    for (std::size_t p = 2; p < start_.size(); ++p) start_[p] += start_[p - 1];
    by_patch_.resize(patch_.size());
    std::size_t i = 0;
    for (auto& hits : flight.hits)
        for (Hit& hit : hits) {
            by_patch_[start_[patch_[i] + 1]++] = {&hit, sides_[i]};
            ++i;
        }
    start_.pop_back();
}

}  // namespace corpuscle::gas
