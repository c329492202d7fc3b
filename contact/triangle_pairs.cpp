// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/triangle_pairs.hpp"

#include <algorithm>

namespace corpuscle::contact {

TrianglePairs::TrianglePairs(const Patches& patches)
    : patches_(patches), tree_(patches.size()), patch_box_(patches.size()) {}

void TrianglePairs::update(std::span<const Box> triangle_boxes) {
    boxes_ = triangle_boxes;
    for (std::size_t p = 0; p < patches_.size(); ++p) {
        patch_box_[p] = Box{};
        for (const Index t : patches_[p]) patch_box_[p].include(boxes_[t]);
    }
    tree_.update(patch_box_);
    tree_.self_pairs(pairs_);
    for (std::size_t p = 0; p < patches_.size(); ++p)
        pairs_.emplace_back(static_cast<Index>(p), static_cast<Index>(p));
    std::sort(pairs_.begin(), pairs_.end());
}

}  // namespace corpuscle::contact
