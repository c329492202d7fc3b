// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/near_search.hpp"

#include <algorithm>

namespace corpuscle::contact {
namespace {

/// Bound of the rounding of a separation: some 2^-24 of coordinates, which are at most 1.
constexpr double SINGLE = 2e-6;

constexpr Index SEVERAL = -1;

/// What `of(triangle)` is for all triangles of a patch, or SEVERAL.
template <class Of>
Index common_of(std::span<const Index> triangles, Of&& of) {
    const Index first = of(triangles.front());
    const auto is_other = [&](Index t) { return of(t) != first; };
    return std::any_of(triangles.begin(), triangles.end(), is_other) ? SEVERAL : first;
}

}  // namespace

NearSearch::NearSearch(const Cloth& cloth, double reach)
    : cloth_(cloth),
      patches_(cloth.patches.size()),
      half_reach_(cloth.triangles.size(), 0.0),
      nodes_(cloth),
      edges_(cloth),
      triangles_(cloth),
      edges_by_edges_(edges_, edges_),
      nodes_by_triangles_(nodes_, triangles_),
      triangles_by_nodes_(triangles_, nodes_),
      tree_(patches_),
      patch_box_(patches_) {
    find_half_reach(reach);
    const auto body_of = [&](Index t) {
        const auto& [a, b, c] = cloth.triangles[t];
        const Index body = cloth.body[a];
        return body == cloth.body[b] && body == cloth.body[c] ? body : SEVERAL;
    };
    for (std::size_t p = 0; p < patches_; ++p) {
        const auto triangles = cloth.patches[p];
        patch_part_.push_back(common_of(triangles, [&](Index t) { return cloth.part[t]; }));
        patch_body_.push_back(common_of(triangles, body_of));
    }
}

void NearSearch::find_half_reach(double reach) {
    for (std::size_t c = 0; c < cloth_.thickness.size(); ++c)
        for (std::size_t t = 0; t < half_reach_.size(); ++t)
            if (cloth_.rules.concerns(static_cast<int>(c), cloth_.part[t]))
                half_reach_[t] = std::max(half_reach_[t], 0.5 * reach * cloth_.thickness[c][t]);
}

void NearSearch::build(const Points& x, const Points& late, std::span<const Box> node_box,
                       std::span<const double> own) {
    find_rounding(node_box);
    const Outline outline{x, late, node_box, half_reach_, own, origin_, rounding_};
    const auto take = [&](auto& blocks) {
        blocks.move(outline);
        blocks.set_bounds(outline);
    };
    take(nodes_);
    take(edges_);
    take(triangles_);
    knows_boxes_ = true;
    pair_patches();
}

void NearSearch::renew(std::span<const Index> triangles, const Points& x, const Points& late,
                       std::span<const Box> node_box, std::span<const double> own) {
    const Outline outline{x, late, node_box, half_reach_, own, origin_, rounding_};
    const auto take = [&](auto& blocks) {
        blocks.move(outline);
        if (!knows_boxes_) return blocks.set_bounds(outline);
        for (const Index t : triangles)
            for (Index side = 0; side < 3; ++side)
                if (const Index block = blocks.place(t, side).block; block >= 0)
                    blocks.renew_bounds(block, outline);
    };
    take(nodes_);
    take(edges_);
    take(triangles_);
    knows_boxes_ = true;
}

void NearSearch::find_rounding(std::span<const Box> node_box) {
    Box all;
    for (const Index node : cloth_.nodes) all.include(node_box[node]);
    origin_ = 0.5 * (all.low + all.high);
    rounding_ = SINGLE * (all.high - all.low).maxCoeff();
}

void NearSearch::pair_patches() {
    for (std::size_t p = 0; p < patches_; ++p) {
        const Bounds& box = triangles_.of_patch(p);
        for (int k = 0; k < 3; ++k) {
            patch_box_[p].low[k] = box.low[k];
            patch_box_[p].high[k] = box.high[k];
        }
    }
    tree_.update(patch_box_);
    tree_.self_pairs(pairs_);
    for (std::size_t p = 0; p < patches_; ++p)
        pairs_.emplace_back(static_cast<Index>(p), static_cast<Index>(p));
    std::erase_if(pairs_, [&](const auto& pair) { return !may_touch(pair.first, pair.second); });
    std::sort(pairs_.begin(), pairs_.end());
}

/// Not a body with itself, and only parts that a card has touch.
bool NearSearch::may_touch(Index p, Index q) const {
    if (patch_body_[p] != SEVERAL && patch_body_[p] == patch_body_[q]) return false;
    const Index a = patch_part_[p], b = patch_part_[q];
    if (a == SEVERAL || b == SEVERAL) return true;
    const Rules& rules = cloth_.rules;
    return rules.nodes_against(a, b) != Rules::NONE || rules.nodes_against(b, a) != Rules::NONE ||
           rules.edges_against(a, b) != Rules::NONE;
}

}  // namespace corpuscle::contact
