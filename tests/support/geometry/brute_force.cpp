// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tests/support/geometry/brute_force.hpp"

#include "contact/geometry/orientation.hpp"

namespace corpuscle::contact::brute_force {

std::vector<std::pair<Index, Index>> self_pairs(std::span<const Box> boxes) {
    std::vector<std::pair<Index, Index>> found;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (std::size_t j = i + 1; j < boxes.size(); ++j)
            if (boxes[i].overlaps(boxes[j]))
                found.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
    return found;
}

std::vector<std::pair<Index, Index>> crossings(std::span<const Triangle> triangles,
                                               std::span<const Vec3> x) {
    std::vector<std::pair<Index, Index>> found;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t j = i + 1; j < triangles.size(); ++j)
            if (!share_node(triangles[i], triangles[j]) &&
                triangles_cross(triangles[i], triangles[j], x))
                found.emplace_back(static_cast<Index>(i), static_cast<Index>(j));
    return found;
}

}  // namespace corpuscle::contact::brute_force
