// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/near_search.hpp"

#include <utility>

#include "solver/base/parallel.hpp"
#include "solver/base/sorted.hpp"

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
    const auto take = [&](auto& blocks) {
        return parallel::alone([&] {
            std::vector<Index> renewed;
            for (const Index t : triangles)
                for (Index side = 0; side < 3; ++side)
                    if (const Index block = blocks.place(t, side).block; block >= 0)
                        renewed.push_back(block);
            sort_unique(renewed);
            for (const Index block : renewed) blocks.renew_bounds(block, outline);
        });
    };
    parallel::side_by_side(take(nodes_), take(edges_), take(triangles_));
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
