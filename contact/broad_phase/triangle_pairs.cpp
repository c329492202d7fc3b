// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/triangle_pairs.hpp"

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

TrianglePairs::TrianglePairs(const Patches& patches)
    : patches_(patches), patch_box_(patches.size()), patch_bounds_(patches.size()) {
    for (auto& side : low_) side.resize(patches.triangle.size());
    for (auto& side : high_) side.resize(patches.triangle.size());
}

void TrianglePairs::set_bounds(Index i, const Box& box) {
    for (int k = 0; k < 3; ++k) {
        low_[k][i] = below(box.low[k]);
        high_[k][i] = above(box.high[k]);
    }
}

void TrianglePairs::update(std::span<const Box> triangle_boxes) {
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        Box& all = patch_box_[p];
        all = Box{};
        for (Index i = patches_.start[p]; i < patches_.start[p + 1]; ++i) {
            const Box& box = triangle_boxes[patches_.triangle[i]];
            all.include(box);
            set_bounds(i, box);
        }
        for (int k = 0; k < 3; ++k) {
            patch_bounds_[p].low[k] = below(all.low[k]);
            patch_bounds_[p].high[k] = above(all.high[k]);
        }
    }
    tree_.update(patch_box_);
    tree_.self_pairs(pairs_);
    for (std::size_t p = 0; p < patches_.size(); ++p)
        pairs_.emplace_back(static_cast<Index>(p), static_cast<Index>(p));
    std::sort(pairs_.begin(), pairs_.end());
}

}  // namespace corpuscle::contact
