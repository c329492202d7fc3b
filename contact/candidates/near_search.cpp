// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/near_search.hpp"

#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::contact {
namespace {

/// Bound of the rounding of a separation: some 2^-24 of coordinates, which are at most 1.
constexpr double SINGLE = 2e-6;

constexpr std::size_t SEARCHED_PATCHES_A_CHUNK = 2;

}  // namespace

NearSearch::NearSearch(const Cloth& cloth, std::vector<double> margin, const Pieces& pieces)
    : pieces_(pieces),
      margin_(std::move(margin)),
      nodes_(cloth),
      edges_(cloth),
      triangles_(cloth),
      edges_by_edges_(edges_, edges_),
      nodes_by_triangles_(nodes_, triangles_),
      triangles_by_nodes_(triangles_, nodes_) {}

void NearSearch::build(const Points& x, const Points& late, std::span<const Box> node_box,
                       std::span<const double> own) {
    find_rounding(node_box);
    const Outline outline{x, late, node_box, margin_, own, origin_, rounding_};
    move(outline, true);
}

void NearSearch::renew(std::span<const Index> triangles, const Points& x, const Points& late,
                       std::span<const Box> node_box, std::span<const double> own) {
    const Outline outline{x, late, node_box, margin_, own, origin_, rounding_};
    const bool knew_boxes = knows_boxes_;
    move(outline, !knew_boxes);
    if (!knew_boxes) return;
    const auto take = [&](auto& blocks, Renewed& renewed) {
        renewed.is_taken.resize(static_cast<std::size_t>(blocks.start().back()), 0);
        for (const Index t : triangles)
            for (Index side = 0; side < 3; ++side) {
                const Index block = blocks.place(t, side).block;
                if (block < 0 || std::exchange(renewed.is_taken[block], 1) != 0) continue;
                blocks.renew_bounds(block, outline);
                renewed.blocks.push_back(block);
            }
        for (const Index block : renewed.blocks) renewed.is_taken[block] = 0;
        renewed.blocks.clear();
    };
    parallel::side_by_side(parallel::alone([&] { take(nodes_, renewed_[0]); }),
                           parallel::alone([&] { take(edges_, renewed_[1]); }),
                           parallel::alone([&] { take(triangles_, renewed_[2]); }));
}

/// Takes all places anew, and all boxes.
void NearSearch::move(const Outline& outline, bool boxes_too) {
    const std::vector<Index>& patches = pieces_.patches;
    const auto each_patch = [&](auto& blocks) {
        const auto take = [&blocks, &patches, &outline, boxes_too](std::size_t i) {
            blocks.move(patches[i], outline);
            if (boxes_too) blocks.set_bounds(patches[i], outline);
        };
        return parallel::each(patches.size(), take, SEARCHED_PATCHES_A_CHUNK);
    };
    parallel::side_by_side(each_patch(edges_), each_patch(triangles_), each_patch(nodes_));
    if (!boxes_too) return;
    nodes_.take_patches(patches);
    edges_.take_patches(patches);
    triangles_.take_patches(patches);
    knows_boxes_ = true;
}

void NearSearch::find_rounding(std::span<const Box> node_box) {
    const Box all = parallel::fold(
        pieces_.nodes.size(), Box{},
        [&](Box& box, std::size_t i) { box.include(node_box[pieces_.nodes[i]]); },
        [](Box& box, const Box& more) { box.include(more); });
    origin_ = 0.5 * (all.low + all.high);
    rounding_ = SINGLE * (all.high - all.low).maxCoeff();
}

}  // namespace corpuscle::contact
