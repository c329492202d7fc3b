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
/// Boxes of the same number are taken to be the old ones, moved: the tree is refitted to them, and
/// built anew now and then, because one that is as old as a deployment costs up to 45 times the
/// query. Answers do not depend on it. `tests/support/geometry/brute_force.hpp` is the oracle.
class BroadPhase {
public:
    BroadPhase();
    ~BroadPhase();
    BroadPhase(BroadPhase&&) noexcept;
    BroadPhase& operator=(BroadPhase&&) noexcept;

    /// Takes new boxes, any number of them.
    /// @throws std::invalid_argument for a box that is not finite (FCL would let a NaN overlap
    ///         everything) or is inside out
    void update(std::span<const Box> boxes);

    /// Overlapping pairs i < j among the boxes, sorted.
    void self_pairs(std::vector<std::pair<Index, Index>>& out) const;

    /// Boxes that another one overlaps, ascending. Any number of threads may ask.
    void overlapping(const Box& box, std::vector<Index>& out) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace corpuscle::contact
