// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/broad_phase/broad_phase.hpp"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/narrowphase/collision_object.h>
#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <stdexcept>

namespace corpuscle::contact {
namespace {

using Pairs = std::vector<std::pair<Index, Index>>;

/// FCL wants a shape behind every box; all boxes share this one, which is never asked anything.
struct NoShape : fcl::CollisionGeometryd {
    void computeLocalAABB() override {}
};

/// A box that FCL can hold: the collision object's own box is written directly.
class BoxObject : public fcl::CollisionObjectd {
public:
    BoxObject(const std::shared_ptr<fcl::CollisionGeometryd>& shape, Index index)
        : fcl::CollisionObjectd(shape), row(index) {}

    void set(const Box& box) {
        aabb.min_ = box.low;
        aabb.max_ = box.high;
    }

    const Index row;
};

Index row_of(const fcl::CollisionObjectd* object) {
    return static_cast<const BoxObject*>(object)->row;
}

bool keep_ascending(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* out) {
    static_cast<Pairs*>(out)->push_back(std::minmax(row_of(a), row_of(b)));
    return false;  // true would end the search
}

/// What FCL hands over first: an object of the manager that was asked, or of the other one? It
/// swaps them in some branches, so the object's side tells.
struct TwoSided {
    Pairs* pairs;
    const fcl::CollisionGeometryd* my_shape;
};

bool keep_mine_first(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    const auto& out = *static_cast<TwoSided*>(data);
    const bool a_is_mine = a->collisionGeometry().get() == out.my_shape;
    out.pairs->emplace_back(row_of(a_is_mine ? a : b), row_of(a_is_mine ? b : a));
    return false;
}

bool keep_other(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
    const Index row = row_of(a);
    static_cast<std::vector<Index>*>(data)->push_back(row >= 0 ? row : row_of(b));
    return false;
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
    std::shared_ptr<NoShape> shape = std::make_shared<NoShape>();
    std::deque<BoxObject> object;  ///< never moves: FCL keeps pointers
    std::vector<fcl::CollisionObjectd*> in_use;
    mutable fcl::DynamicAABBTreeCollisionManagerd
        manager;  ///< its collide(other) is not const-correct

    void grow(std::size_t n) {
        while (object.size() < n) object.emplace_back(shape, static_cast<Index>(object.size()));
    }
};

BroadPhase::BroadPhase(std::size_t capacity_hint) : tree_(std::make_unique<Tree>()) {
    tree_->grow(capacity_hint);
    tree_->in_use.reserve(capacity_hint);
}
BroadPhase::~BroadPhase() = default;
BroadPhase::BroadPhase(BroadPhase&&) noexcept = default;
BroadPhase& BroadPhase::operator=(BroadPhase&&) noexcept = default;

void BroadPhase::update(std::span<const Box> boxes) {
    check(boxes);
    clear();
    Tree& tree = *tree_;
    tree.grow(boxes.size());
    Box all;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        tree.object[i].set(boxes[i]);
        tree.in_use.push_back(&tree.object[i]);
        all.include(boxes[i]);
    }
    // Level 2 sorts by Morton codes, three times as fast as the top-down split of level 0, but
    // divides by the extent of the scene in each direction: a flat scene has none.
    const bool is_flat = !boxes.empty() && ((all.high - all.low).array() <= 0.0).any();
    tree.manager.tree_init_level = is_flat ? 0 : 2;
    tree.manager.registerObjects(tree.in_use);
    tree.manager.setup();
}

void BroadPhase::clear() {
    if (tree_->in_use.empty()) return;
    tree_->in_use.clear();
    tree_->manager.clear();
}

void BroadPhase::self_pairs(Pairs& out) const {
    out.clear();
    if (tree_->in_use.size() < 2) return;
    tree_->manager.collide(&out, keep_ascending);
    // FCL's order depends on addresses
    std::sort(out.begin(), out.end());
}

void BroadPhase::pairs(const BroadPhase& other, Pairs& out) const {
    out.clear();
    if (tree_->in_use.empty() || other.tree_->in_use.empty()) return;
    TwoSided data{&out, tree_->shape.get()};
    tree_->manager.collide(&other.tree_->manager, &data, keep_mine_first);
    std::sort(out.begin(), out.end());
}

void BroadPhase::overlapping(const Box& box, std::vector<Index>& out) const {
    out.clear();
    if (tree_->in_use.empty()) return;
    constexpr Index WHO_ASKS = -1;
    thread_local BoxObject asking(std::make_shared<NoShape>(), WHO_ASKS);
    asking.set(box);
    tree_->manager.collide(&asking, &out, keep_other);
    std::sort(out.begin(), out.end());
}

}  // namespace corpuscle::contact
