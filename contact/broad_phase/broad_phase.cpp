// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/broad_phase.hpp"

#include <fcl/broadphase/detail/hierarchy_tree.h>
#include <fcl/math/bv/AABB.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <stdexcept>

namespace corpuscle::contact {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;
using Hierarchy = fcl::detail::HierarchyTree<fcl::AABBd>;
using Node = fcl::detail::NodeBase<fcl::AABBd>;

/// Updates between two buildings of a tree: refitting takes less time, but its nodes come to overlap.
constexpr int REFITS = 16;

fcl::AABBd aabb(const Box& box) {
    fcl::AABBd out;
    out.min_ = box.low;
    out.max_ = box.high;
    return out;
}

void check(std::span<const Box> boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Box& b = boxes[i];
        if (!b.low.allFinite() || !b.high.allFinite() || (b.low.array() > b.high.array()).any())
            throw std::invalid_argument(
                fmt::format("box {} from ({}, {}, {}) to ({}, {}, {}) is not a finite box", i,
                            b.low.x(), b.low.y(), b.low.z(), b.high.x(), b.high.y(), b.high.z()));
    }
}

}  // namespace

struct BroadPhase::Tree {
    Hierarchy hierarchy;
    std::vector<Node*> leaf;  ///< by row; the hierarchy's own
    int refits = 0;           ///< since it was built

    void build(std::span<const Box> boxes);
    void find(const fcl::AABBd& box, std::vector<Index>& out) const;
};

BroadPhase::BroadPhase() : tree_(std::make_unique<Tree>()) {}
BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

void BroadPhase::update(std::span<const Box> boxes) {
    check(boxes);
    Tree& tree = *tree_;
    if (boxes.size() != tree.leaf.size() || tree.refits == REFITS) return tree.build(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) tree.leaf[i]->bv = aabb(boxes[i]);
    tree.hierarchy.refit();
    ++tree.refits;
}

void BroadPhase::Tree::build(std::span<const Box> boxes) {
    hierarchy.clear();
    leaf.clear();
    refits = 0;
    if (boxes.empty()) return;
    Box all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        leaf.push_back(new Node);  // the hierarchy's from init() on
        leaf.back()->bv = aabb(boxes[i]);
        leaf.back()->data = reinterpret_cast<void*>(static_cast<std::intptr_t>(i));
        all.include(boxes[i]);
    }
    // Level 2 sorts by Morton codes, three times as fast as the top-down split of level 0, but
    // divides by the extent of the scene in each direction: a flat scene has none.
    const bool is_flat = ((all.high - all.low).array() <= 0.0).any();
    std::vector<Node*> sorted = leaf;
    hierarchy.init(sorted, is_flat ? 0 : 2);
}

void BroadPhase::Tree::find(const fcl::AABBd& box, std::vector<Index>& out) const {
    thread_local std::vector<const Node*> left;
    left.assign(1, hierarchy.getRoot());
    while (!left.empty()) {
        const Node& node = *left.back();
        left.pop_back();
        if (!node.bv.overlap(box)) continue;
        if (node.isLeaf())
            out.push_back(static_cast<Index>(reinterpret_cast<std::intptr_t>(node.data)));
        else
            left.insert(left.end(), {node.children[0], node.children[1]});
    }
}

void BroadPhase::overlapping(const Box& box, std::vector<Index>& out) const {
    out.clear();
    if (tree_->leaf.empty()) return;
    tree_->find(aabb(box), out);
    std::sort(out.begin(), out.end());
}

void BroadPhase::self_pairs(Pairs& out) const {
    out.clear();
    std::vector<Index> found;
    for (std::size_t i = 0; i < tree_->leaf.size(); ++i) {
        found.clear();
        tree_->find(tree_->leaf[i]->bv, found);
        for (const Index j : found)
            if (const auto first = static_cast<Index>(i); first < j) out.emplace_back(first, j);
    }
    std::sort(out.begin(), out.end());
}

}  // namespace corpuscle::contact
