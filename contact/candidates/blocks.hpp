// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <span>
#include <vector>

#include "contact/broad_phase/bounds.hpp"
#include "contact/candidates/separation.hpp"
#include "contact/surface/cloth.hpp"

namespace corpuscle::contact {

/// Where the cloth is and will be, and how near to each other its places matter.
struct Outline {
    const Points &x, &late;          ///< N × 3                                             [m]
    std::span<const Box> node_box;   ///< of all that each node may reach                   [m]
    std::span<const double> margin;  ///< by triangle: its part of the gap that matters     [m]
    std::span<const double> own;     ///< by node: what is added for its own sake           [m]
    Vec3 origin;                     ///< from which single precision counts                [m]
    double rounding;                 ///< of that, at most                                  [m]
};

/// The nodes (CORNERS 1), edges (2) or triangles (3) of all patches, in blocks of eight that lie
/// close together along the cloth: each node and edge once, with the triangle that owns it.
template <int CORNERS>
class Blocks {
public:
    struct PackedBlock : EightBounds {
        Bounds whole;  ///< box of them all
        EightMoving<CORNERS> moving = {};
        Eight margin = {};
        std::array<Index, EIGHT> triangle, side;  ///< owner, and which of its nodes or edges
        std::array<std::array<Index, CORNERS>, EIGHT> node;
    };
    struct Lane {
        Index block = -1;
        int lane = 0;
    };

    explicit Blocks(const Cloth& cloth);

    /// Takes all places of a patch anew.
    void move(Index patch, const Outline& outline);
    /// Takes all boxes of a patch anew, for take_patches().
    void set_bounds(Index patch, const Outline& outline);
    /// Takes the boxes of patches whose bounds were set; those of all other patches overlap with
    /// nothing.
    void take_patches(std::span<const Index> patches);
    /// Takes a block's box anew; those that hold it only grow.
    void renew_bounds(Index block, const Outline& outline);

    [[nodiscard]] const PackedBlock& operator[](Index block) const { return block_[block]; }
    /// Of a triangle's node or edge; those that it does not own have none.
    [[nodiscard]] Lane place(Index triangle, int side = 0) const {
        return place_[3 * static_cast<std::size_t>(triangle) + static_cast<std::size_t>(side)];
    }
    [[nodiscard]] std::span<const Index> start() const { return start_; }

    /// meet(block) for all blocks of a patch whose box overlaps with this one.
    template <class Meet>
    void for_each_near(const Bounds& box, std::size_t patch, Meet&& meet) const {
        for (Index g = group_start_[patch]; g < group_start_[patch + 1]; ++g)
            for (unsigned bits = group_[g].overlapping(box); bits != 0; bits &= bits - 1)
                meet(start_[patch] + EIGHT * (g - group_start_[patch]) + std::countr_zero(bits));
    }
    /// visit(patch) for all patches whose box overlaps with this one, ascending.
    template <class Visit>
    void for_each_patch_near(const Bounds& box, Visit&& visit) const {
        for (std::size_t g = 0; g < patches_.size(); ++g)
            for (unsigned bits = patches_[g].overlapping(box); bits != 0; bits &= bits - 1)
                visit(EIGHT * g + static_cast<std::size_t>(std::countr_zero(bits)));
    }
    /// The box of a patch of them.
    [[nodiscard]] Bounds of_patch(std::size_t patch) const {
        return patches_[patch / EIGHT][static_cast<int>(patch % EIGHT)];
    }

private:
    void place(PackedBlock& block, const Outline& outline) const;
    void bound(Index block, const Outline& outline);
    void set_patch(std::size_t patch, const Bounds& box) {
        patches_[patch / EIGHT].set(static_cast<int>(patch % EIGHT), box);
    }

    std::vector<PackedBlock> block_;
    std::vector<Index> start_;          ///< of each patch's blocks
    std::vector<EightBounds> group_;    ///< boxes of eight blocks of a patch
    std::vector<Index> group_start_;    ///< of each patch's groups
    std::vector<EightBounds> patches_;  ///< boxes of the patches, eight by eight
    std::vector<Bounds> whole_;         ///< of each patch, as set last
    std::vector<Index> patch_;          ///< by block
    std::vector<Lane> place_;           ///< by triangle and its three sides
};

/// A lane of a block eight times over.
template <int CORNERS>
[[nodiscard]] EightMoving<CORNERS> spread(const EightMoving<CORNERS>& from, int lane) {
    EightMoving<CORNERS> out;
    for (int c = 0; c < CORNERS; ++c)
        for (int k = 0; k < 3; ++k) {
            out.now[c][k] = all_eight(from.now[c][k][lane]);
            out.late[c][k] = all_eight(from.late[c][k][lane]);
        }
    return out;
}

/// Which of eight pairs may come within the margins of both sides, between now and late: along a
/// fixed direction the least separation is never below the line from now to late.
[[nodiscard]] inline unsigned near(const EightSeparations& apart, const Eight& margins) {
    const Eight least = least_of(apart.now, apart.late);
    return bits_of((least <= 0.0F) | (least * least <= margins * margins * apart.square));
}

}  // namespace corpuscle::contact
