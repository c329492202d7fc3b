// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/candidates/blocks.hpp"
#include "contact/candidates/shared_nodes.hpp"
#include "contact/culling/patch_pairs.hpp"

namespace corpuscle::contact {

/// A node or an edge of the triangle that owns it, or a whole triangle (side 0).
struct Feature {
    Index triangle, side;
};

/// Lower bounds of a pair's distance: now and late; in between it is not below the line from one to
/// the other.                                                                               [m]
struct Distances {
    double now, late;
};

/// Which nodes and triangles, and which edges, of two patches of cloth may come near to each other
/// until late: blocks of eight are paired by their boxes; then eight pairs at once are looked at
/// along the line between their nearest places. In single precision, on the safe side.
class NearSearch {
public:
    /// @param margin  by triangle: its part of the gap that matters                        [m]
    /// @param pieces  what is searched; may change at a build
    NearSearch(const Cloth& cloth, std::vector<double> margin, const Pieces& pieces);

    /// Takes the cloth anew.
    /// @param x, late    where each node is predicted to be, now and late, N × 3            [m]
    /// @param node_box   of all that each node may reach until late
    /// @param own        by node: how far it may be from its prediction                     [m]
    void build(const Points& x, const Points& late, std::span<const Box> node_box,
               std::span<const double> own);

    /// Takes some triangles anew, with all that they own; the others' boxes stay as they are. All
    /// places are taken anew.
    void renew(std::span<const Index> triangles, const Points& x, const Points& late,
               std::span<const Box> node_box, std::span<const double> own);

    /// Each pair between a pair of patches once: edges(Feature, Feature, Distances) and node(Feature,
    /// triangle, Distances). None has a node in common.
    template <class Edges, class Node>
    void for_each_in(const PatchPair& patches, Edges&& edges, Node&& node) const {
        const auto [p, q] = patches;
        for_each_pair(edges_, p, edges_, q, edges_by_edges_, p == q, edges);
        const auto turned = [&](Feature t, Feature n, Distances apart) {
            node(n, t.triangle, apart);
        };
        for_each_pair(triangles_, p, nodes_, q, triangles_by_nodes_, false, turned);
        if (p != q) for_each_pair(triangles_, q, nodes_, p, triangles_by_nodes_, false, turned);
    }

    /// Likewise each pair of a triangle, with what it owns, and all others.
    template <class Edges, class Node>
    void for_each_near(Index triangle, Edges&& edges, Node&& node) const {
        for (Index side = 0; side < 3; ++side) {
            if (const auto [block, lane] = edges_.place(triangle, side); block >= 0)
                meet_all(edges_, block, lane, edges_, edges_by_edges_, edges);
            if (const auto [block, lane] = nodes_.place(triangle, side); block >= 0)
                meet_all(
                    nodes_, block, lane, triangles_, nodes_by_triangles_,
                    [&](Feature n, Feature t, Distances apart) { node(n, t.triangle, apart); });
        }
        const auto [block, lane] = triangles_.place(triangle);
        meet_all(triangles_, block, lane, nodes_, triangles_by_nodes_,
                 [&](Feature t, Feature n, Distances apart) { node(n, t.triangle, apart); });
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(origin_, rounding_);
    }

private:
    /// One lane of a block against another block.
    /// @param allowed  lanes that are to be met
    template <int A, int B, class Meet>
    void meet_block(const typename Blocks<A>::PackedBlock& mine, int lane,
                    const typename Blocks<B>::PackedBlock& other, unsigned allowed,
                    Meet&& meet) const {
        const EightSeparations apart = separations(spread(mine.moving, lane), other.moving);
        for (unsigned bits = allowed & near(apart, mine.margin[lane] + other.margin); bits != 0;
             bits &= bits - 1) {
            const int l = std::countr_zero(bits);
            const double length = std::sqrt(static_cast<double>(apart.square[l]));
            const auto distance = [&](float along) {
                return length > 0.0 ? static_cast<double>(along) / length - 2.0 * rounding_ : 0.0;
            };
            meet(Feature{mine.triangle[lane], mine.side[lane]},
                 Feature{other.triangle[l], other.side[l]},
                 Distances{std::max(0.0, distance(apart.now[l])), distance(apart.late[l])});
        }
    }

    /// One lane of a block against all others, patch by patch.
    template <int A, int B, class Meet>
    void meet_all(const Blocks<A>& mine, Index block, int lane, const Blocks<B>& others,
                  const SharedNodes& shared, Meet&& meet) const {
        const Bounds box = mine[block][lane];
        others.for_each_patch_near(box, [&](std::size_t patch) {
            others.for_each_near(box, patch, [&](Index b) {
                const unsigned allowed =
                    others[b].overlapping(box) & ~of_lane(shared.lanes(block, b), lane);
                if (allowed != 0) meet_block<A, B>(mine[block], lane, others[b], allowed, meet);
            });
        });
    }

    /// @param is_same  both are the same: each pair is met once, none with itself
    template <int A, int B, class Meet>
    void for_each_pair(const Blocks<A>& mine, Index p, const Blocks<B>& others, Index q,
                       const SharedNodes& shared, bool is_same, Meet&& meet) const {
        for (Index i = mine.start()[p]; i < mine.start()[p + 1]; ++i) {
            const typename Blocks<A>::PackedBlock& block = mine[i];
            others.for_each_near(block.whole, q, [&](Index j) {
                if (is_same && j < i) return;
                const std::uint64_t neighbours = shared.lanes(i, j);
                for (unsigned bits = block.overlapping(others[j].whole); bits != 0;
                     bits &= bits - 1) {
                    const int lane = std::countr_zero(bits);
                    unsigned allowed =
                        others[j].overlapping(block[lane]) & ~of_lane(neighbours, lane);
                    if (is_same && j == i) allowed &= ~0U << (lane + 1);
                    if (allowed != 0) meet_block<A, B>(block, lane, others[j], allowed, meet);
                }
            });
        }
    }

    void find_rounding(std::span<const Box> node_box);
    void move(const Outline& outline, bool boxes_too);

    const Pieces& pieces_;
    std::vector<double> margin_;  ///< by triangle                                         [m]
    Blocks<1> nodes_;
    Blocks<2> edges_;
    Blocks<3> triangles_;
    SharedNodes edges_by_edges_, nodes_by_triangles_, triangles_by_nodes_;
    Vec3 origin_ = Vec3::Zero();  ///< of single precision                                    [m]
    double rounding_ = 0.0;       ///< of that, at most                                       [m]
    bool knows_boxes_ = false;    ///< not after a restart
};

}  // namespace corpuscle::contact
