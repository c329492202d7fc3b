// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/triangle_pairs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace corpuscle::contact {
namespace {

float below(double x) {
    const auto f = static_cast<float>(x);
    return f > x ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}

float above(double x) {
    return -below(-x);
}

}  // namespace

TrianglePairs::TrianglePairs(const Patches& patches, std::span<const Triangle> triangles,
                             std::span<const Vec3> x, double margin)
    : patches_(patches), bounds_(patches.size()) {
    std::vector<Box> patch_box(patches.size());
    for (std::size_t p = 0; p < patches.size(); ++p) {
        const auto rows = patches[p];
        bounds_[p].resize((rows.size() + EIGHT - 1) / EIGHT);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Box box = triangle_box(triangles[rows[i]], x, x, margin);
            const auto& [low, high] = box;
            patch_box[p].include(box);
            bounds_[p][i / EIGHT].set(static_cast<int>(i % EIGHT),
                                      {{below(low[0]), below(low[1]), below(low[2])},
                                       {above(high[0]), above(high[1]), above(high[2])}});
        }
    }
    BroadPhase tree;
    tree.update(patch_box);
    tree.self_pairs(pairs_);
    for (std::size_t p = 0; p < patches.size(); ++p)
        pairs_.emplace_back(static_cast<Index>(p), static_cast<Index>(p));
    std::sort(pairs_.begin(), pairs_.end());
}

}  // namespace corpuscle::contact
