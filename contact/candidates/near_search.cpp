// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/near_search.hpp"

namespace corpuscle::contact {
namespace {

/// Bound of the rounding of a separation: some 2^-24 of coordinates, which are at most 1.
constexpr double SINGLE = 2e-6;

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
    const auto take = [&](auto& blocks) {
        blocks.move(pieces_.patches, outline);
        blocks.set_bounds(pieces_.patches, outline);
    };
    take(nodes_);
    take(edges_);
    take(triangles_);
    knows_boxes_ = true;
}

void NearSearch::renew(std::span<const Index> triangles, const Points& x, const Points& late,
                       std::span<const Box> node_box, std::span<const double> own) {
    const Outline outline{x, late, node_box, margin_, own, origin_, rounding_};
    const auto take = [&](auto& blocks) {
        blocks.move(pieces_.patches, outline);
        if (!knows_boxes_) return blocks.set_bounds(pieces_.patches, outline);
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
    for (const Index node : pieces_.nodes) all.include(node_box[node]);
    origin_ = 0.5 * (all.low + all.high);
    rounding_ = SINGLE * (all.high - all.low).maxCoeff();
}

}  // namespace corpuscle::contact
