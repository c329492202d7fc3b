// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/intersections.hpp"

#include <algorithm>

#include "contact/broad_phase/triangle_pairs.hpp"
#include "contact/geometry/orientation.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::contact {

std::vector<std::pair<Index, Index>> crossings(std::span<const Triangle> triangles,
                                               const Patches& patches, std::span<const Vec3> x) {
    const TrianglePairs near(patches, triangles, x, 0.0);
    constexpr std::size_t CHUNK = 16;  // patch pairs
    const auto pairs = near.patch_pairs();
    const auto search = [&](std::size_t i, auto&& take) {
        near.for_each_in(pairs[i], [&](Index a, Index b) {
            if (!share_node(triangles[a], triangles[b]) &&
                triangles_cross(triangles[a], triangles[b], x))
                take(std::minmax(a, b));
        });
    };
    std::vector<std::pair<Index, Index>> found;
    parallel::Gathered<std::pair<Index, Index>>().find(pairs.size(), found, search, CHUNK);
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace corpuscle::contact
