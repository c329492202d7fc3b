// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/triangle_pairs.hpp"

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
    : patches_(patches),
      tree_(patches.size()),
      patch_box_(patches.size()),
      patch_bounds_(patches.size()) {
    for (auto& side : low_) side.resize(patches.triangle.size());
    for (auto& side : high_) side.resize(patches.triangle.size());
    place_.resize(patches.triangle.size());
    patch_of_.resize(patches.triangle.size());
    for (std::size_t p = 0; p < patches.size(); ++p)
        for (Index i = patches.start[p]; i < patches.start[p + 1]; ++i) {
            place_[patches.triangle[i]] = i;
            patch_of_[patches.triangle[i]] = static_cast<Index>(p);
        }
}

void TrianglePairs::set_bounds(Index i, const Box& box) {
    for (int k = 0; k < 3; ++k) {
        low_[k][i] = below(box.low[k]);
        high_[k][i] = above(box.high[k]);
    }
}

void TrianglePairs::renew(Index triangle, const Box& box) {
    set_bounds(place_[triangle], box);
    Bounds& all = patch_bounds_[patch_of_[triangle]];
    for (int k = 0; k < 3; ++k) {
        all.low[k] = std::min(all.low[k], below(box.low[k]));
        all.high[k] = std::max(all.high[k], above(box.high[k]));
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
