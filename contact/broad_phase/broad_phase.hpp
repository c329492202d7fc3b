// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "contact/geometry/box.hpp"
#include "contact/surface/patches.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::contact {

/// Which boxes overlap, found by FCL's dynamic AABB tree.
///
/// Objects are made once and reused; the tree is built anew by every update(), because refitting an
/// old one to a bag that has moved costs up to 45 times the query. `tests/support/geometry/brute_force.hpp` is the oracle.
class BroadPhase {
public:
    explicit BroadPhase(std::size_t capacity_hint = 0);
    ~BroadPhase();
    BroadPhase(BroadPhase&&) noexcept;
    BroadPhase& operator=(BroadPhase&&) noexcept;

    /// Takes new boxes, any number of them.
    /// @throws std::invalid_argument for a box that is not finite or is inside out: FCL would let a
    /// NaN
    ///         overlap everything
    void update(std::span<const Box> boxes);

    /// Takes the boxes away; update() does so too. For who has threads beside that need none.
    void clear();

    /// Overlapping pairs i < j among the boxes, sorted.
    void self_pairs(std::vector<std::pair<Index, Index>>& out) const;

    /// Overlapping pairs (mine, theirs), sorted.
    void pairs(const BroadPhase& other, std::vector<std::pair<Index, Index>>& out) const;

    /// Boxes that another one overlaps, ascending. Any number of threads may ask.
    void overlapping(const Box& box, std::vector<Index>& out) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace corpuscle::contact
