// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/blocks.hpp"

#include <algorithm>
#include <limits>

namespace corpuscle::contact {
namespace {

std::array<float, 3> single(const Vec3& p, const Vec3& origin) {
    return {static_cast<float>(p.x() - origin.x()), static_cast<float>(p.y() - origin.y()),
            static_cast<float>(p.z() - origin.z())};
}

/// A node, an edge or a triangle that goes into a block.
struct BlockItem {
    Index triangle, side;
    Vec3 middle;  ///< in the reference shape                                               [m]
};

/// Brings what lies close together next to each other, eight by eight: cuts across the longest
/// extent, at a multiple of eight.
void bring_together(std::span<BlockItem> items) {
    if (items.size() <= EIGHT) return;
    Box all;
    for (const BlockItem& item : items) all.include(item.middle);
    Index axis = 0;
    (all.high - all.low).maxCoeff(&axis);
    std::sort(items.begin(), items.end(), [axis](const BlockItem& a, const BlockItem& b) {
        if (a.middle[axis] != b.middle[axis]) return a.middle[axis] < b.middle[axis];
        return std::pair(a.triangle, a.side) < std::pair(b.triangle, b.side);
    });
    const std::size_t cut = (items.size() / 2 + EIGHT - 1) / EIGHT * EIGHT;
    bring_together(items.first(cut));
    bring_together(items.subspan(cut));
}

}  // namespace

template <int CORNERS>
Blocks<CORNERS>::Blocks(const Cloth& cloth)
    : start_{0}, group_start_{0}, place_(3 * cloth.triangles.size()) {
    constexpr Index SIDES = CORNERS == 3 ? 1 : 3;
    std::vector<BlockItem> items;
    for (std::size_t p = 0; p < cloth.patches.size(); ++p) {
        items.clear();
        for (const Index t : cloth.patches[p])
            for (Index side = 0; side < SIDES; ++side) {
                if (CORNERS == 1 && !cloth.owns_node(t, side)) continue;
                if (CORNERS == 2 && !cloth.owns_edge(t, side)) continue;
                Vec3 middle = Vec3::Zero();
                for (Index c = 0; c < CORNERS; ++c)
                    middle += cloth.reference_x[cloth.triangles[t][(side + c) % 3]] / CORNERS;
                items.push_back({t, side, middle});
            }
        bring_together(items);
        for (std::size_t i = 0; i < items.size(); ++i) {
            const int lane = static_cast<int>(i % EIGHT);
            if (lane == 0) {
                block_.emplace_back().triangle.fill(-1);
                patch_.push_back(static_cast<Index>(p));
            }
            const auto [t, side, middle] = items[i];
            block_.back().triangle[lane] = t;
            block_.back().side[lane] = side;
            for (Index c = 0; c < CORNERS; ++c)
                block_.back().node[lane][c] = cloth.triangles[t][(side + c) % 3];
            place_[3 * static_cast<std::size_t>(t) + static_cast<std::size_t>(side)] = {
                static_cast<Index>(block_.size() - 1), lane};
        }
        start_.push_back(static_cast<Index>(block_.size()));
        const Index blocks = start_[p + 1] - start_[p];
        group_start_.push_back(group_start_[p] + (blocks + EIGHT - 1) / EIGHT);
    }
    group_.resize(static_cast<std::size_t>(group_start_.back()));
    patches_.resize((cloth.patches.size() + EIGHT - 1) / EIGHT);
    whole_.resize(cloth.patches.size());
}

template <int CORNERS>
void Blocks<CORNERS>::move(Index patch, const Outline& outline) {
    for (Index b = start_[patch]; b < start_[patch + 1]; ++b) place(block_[b], outline);
}

template <int CORNERS>
void Blocks<CORNERS>::place(PackedBlock& block, const Outline& outline) const {
    for (int lane = 0; lane < EIGHT; ++lane) {
        if (block.triangle[lane] < 0) continue;
        double own = 0.0;
        for (int c = 0; c < CORNERS; ++c) {
            const Index node = block.node[lane][c];
            const auto now = single(outline.x[node], outline.origin),
                       late = single(outline.late[node], outline.origin);
            for (int k = 0; k < 3; ++k) {
                block.moving.now[c][k][lane] = now[k];
                block.moving.late[c][k][lane] = late[k];
            }
            own = std::max(own, outline.own[node]);
        }
        block.margin[lane] =
            static_cast<float>(outline.margin[block.triangle[lane]] + own + outline.rounding);
    }
}

template <int CORNERS>
void Blocks<CORNERS>::bound(Index b, const Outline& outline) {
    PackedBlock& block = block_[b];
    for (int lane = 0; lane < EIGHT; ++lane) {
        if (block.triangle[lane] < 0) continue;
        Box box;
        for (const Index node : block.node[lane]) box.include(outline.node_box[node]);
        box.inflate(outline.rounding);
        block.set(lane, {single(box.low, outline.origin), single(box.high, outline.origin)});
    }
    block.whole = block.all();
}

template <int CORNERS>
void Blocks<CORNERS>::set_bounds(Index patch, const Outline& outline) {
    for (Index b = start_[patch]; b < start_[patch + 1]; ++b) {
        const Index at = b - start_[patch];
        bound(b, outline);
        group_[group_start_[patch] + at / EIGHT].set(at % EIGHT, block_[b].whole);
    }
    Bounds whole = EightBounds()[0];
    for (Index g = group_start_[patch]; g < group_start_[patch + 1]; ++g)
        whole.include(group_[g].all());
    whole_[patch] = whole;
}

template <int CORNERS>
void Blocks<CORNERS>::take_patches(std::span<const Index> patches) {
    std::fill(patches_.begin(), patches_.end(), EightBounds());
    for (const Index p : patches) set_patch(static_cast<std::size_t>(p), whole_[p]);
}

template <int CORNERS>
void Blocks<CORNERS>::renew_bounds(Index b, const Outline& outline) {
    bound(b, outline);
    const std::size_t p = patch_[b];
    const Index at = b - start_[p];
    group_[group_start_[p] + at / EIGHT].set(at % EIGHT, block_[b].whole);
    Bounds box = of_patch(p);
    box.include(block_[b].whole);
    set_patch(p, box);
}

template class Blocks<1>;
template class Blocks<2>;
template class Blocks<3>;

}  // namespace corpuscle::contact
