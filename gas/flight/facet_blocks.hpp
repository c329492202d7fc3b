// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "contact/broad_phase/broad_phase.hpp"
#include "gas/flight/block_of_cells.hpp"
#include "solver/base/parallel.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Facets in patches, and FCL's tree of the patches' boxes.
class FacetPatches {
public:
    FacetPatches(std::span<const Triangle> triangles, std::span<const Vec3> x)
        : patches_(contact::make_patches(x, triangles)) {
        for (std::size_t p = 0; p < patches_.size(); ++p)
            first_group_.push_back(first_group_[p] + (patches_[p].size() + GROUP - 1) / GROUP);
        group_box_.resize(first_group_.back());
    }

    /// Boxes of facets that move from x_0 to x_1, `around` wider on each side.                  [m]
    /// visit(facet, box) on all threads
    template <class Visit>
    void update(std::span<const Triangle> triangles, std::span<const Vec3> x_0,
                std::span<const Vec3> x_1, double around, Visit&& visit);

    [[nodiscard]] const contact::Patches& patches() const { return patches_; }
    [[nodiscard]] contact::Patches& patches() { return patches_; }  ///< for sorting
    [[nodiscard]] const contact::BroadPhase& tree() const { return tree_; }
    /// visit(facet) for those of a patch that may overlap a box, and some others.
    template <class Visit>
    void for_some(std::size_t patch, const contact::Box& box, Visit&& visit) const {
        const auto facets = patches_[patch];
        for (std::size_t first = 0, g = first_group_[patch]; first < facets.size();
             first += GROUP, ++g)
            if (group_box_[g].overlaps(box))
                for (const Index facet :
                     facets.subspan(first, std::min(GROUP, facets.size() - first)))
                    visit(facet);
    }
    [[nodiscard]] const contact::Box& all() const { return all_; }  ///< boxes together       [m]
    [[nodiscard]] double around() const { return around_; }         ///< as last updated      [m]

private:
    static constexpr std::size_t GROUP = 8;  ///< facets of a patch, one after the other

    contact::Patches patches_;
    contact::BroadPhase tree_;
    std::vector<contact::Box> box_, group_box_;
    std::vector<std::size_t> first_group_{0};  ///< of each patch
    contact::Box all_;
    double around_ = 0.0;
};

/// A grid's blocks of cells with the facets that may be in them: patches by FCL, then each facet by
/// the range of cells that its box overlaps. All threads ask FCL's tree, each for some blocks.
class FacetBlocks {
public:
    /// A block with facets. Where its part of lists over all blocks begins, or how long it is, is
    /// the caller's.
    struct Block {
        std::size_t number;
        std::size_t facet, facets;  ///< first of the chunk's, how many
        std::size_t entry = 0, slab = 0;
    };

    /// visit(block, cells) for every block of the grid, its facets entered, on all threads; those
    /// without any are forgotten.
    /// @param around  by which the boxes of `range` are wider than the facets               [m]
    /// @param eight   by facet: BlockOfCells::enter(); or none
    template <class Visit>
    void find(const Grid& grid, const FacetPatches& facets, double around,
              std::span<const CellRange> range, std::span<const Index> eight, Visit&& visit,
              parallel::Cut::Where where = parallel::Cut::Where::current());

    /// visit(block) for those with facets in their order, on one thread.
    template <class Visit>
    void for_each_in_turn(Visit&& visit) {
        for (Chunk& chunk : chunks_)
            for (Block& block : chunk.blocks) visit(block);
    }
    /// visit(block, cells) for those with facets, entered again, on all threads.
    template <class Visit>
    void for_each(std::span<const CellRange> range, Visit&& visit,
                  parallel::Cut::Where where = parallel::Cut::Where::current());

private:
    struct Chunk {
        std::vector<Block> blocks;
        std::vector<Index> facets;  ///< block after block
    };
    /// Box of a block of cells, `more` wider; what lies beyond the grid, up to `all`, belongs to the
    /// outermost ones.
    [[nodiscard]] contact::Box box(std::size_t number, const contact::Box& all, double more) const;
    Grid grid_, blocks_;
    std::vector<Chunk> chunks_;
};

template <class Visit>
void FacetPatches::update(std::span<const Triangle> triangles, std::span<const Vec3> x_0,
                          std::span<const Vec3> x_1, double around, Visit&& visit) {
    constexpr std::size_t PATCHES = 2;  // a chunk: some hundred facets
    around_ = around;
    box_.resize(patches_.size());
    const auto bound = [&](std::size_t p) {
        contact::Box all;
        const auto facets = patches_[p];
        for (std::size_t k = 0; k < facets.size(); ++k) {
            contact::Box& group = group_box_[first_group_[p] + k / GROUP];
            const contact::Box box = contact::triangle_box(triangles[facets[k]], x_0, x_1, around);
            visit(facets[k], box);
            if (k % GROUP == 0) group = {};
            group.include(box);
            all.include(box);
        }
        box_[p] = all;
    };
    parallel::for_each(patches_.size(), bound, PATCHES);
    all_ = {};
    for (const contact::Box& box : box_) all_.include(box);
    tree_.update(box_);
}

template <class Visit>
void FacetBlocks::find(const Grid& grid, const FacetPatches& facets, double around,
                       std::span<const CellRange> range, std::span<const Index> eight,
                       Visit&& visit, parallel::Cut::Where where) {
    constexpr double ROUNDING = 1e-9;                           // of the boxes
    constexpr std::size_t MOST_BLOCKS = 8, FEWEST_CHUNKS = 64;  // of a chunk; in a fine grid
    grid_ = grid;
    blocks_ = BlockOfCells::blocks_of(grid);
    const double more = std::max(0.0, around - facets.around()) + ROUNDING * blocks_.edge;
    contact::Box all = facets.all();
    all.inflate(more);
    const std::size_t blocks_a_chunk =
        std::clamp<std::size_t>(blocks_.size() / FEWEST_CHUNKS, 1, MOST_BLOCKS);
    chunks_.resize(parallel::chunk_count(blocks_.size(), blocks_a_chunk));
    const auto over_chunk = [&](std::size_t begin, std::size_t end, std::size_t c) {
        thread_local BlockOfCells cells;
        thread_local std::vector<Index> found;
        Chunk& chunk = chunks_[c];
        chunk.blocks.clear();
        chunk.facets.clear();
        for (std::size_t number = begin; number < end; ++number) {
            const contact::Box here = box(number, all, more);
            facets.tree().overlapping(here, found);
            cells.begin(grid_, number);
            for (const Index patch : found)
                facets.for_some(static_cast<std::size_t>(patch), here, [&](Index facet) {
                    cells.enter(facet, range[facet], eight.empty() ? 0 : eight[facet]);
                });
            Block block{number, chunk.facets.size(), cells.entered()};
            visit(block, cells);
            if (cells.entered() == 0) continue;
            for (std::size_t k = 0; k < cells.entered(); ++k)
                chunk.facets.push_back(cells.facet(k));
            chunk.blocks.push_back(block);
        }
    };
    parallel::for_chunks(blocks_.size(), over_chunk, parallel::Cut(blocks_a_chunk, where));
}

template <class Visit>
void FacetBlocks::for_each(std::span<const CellRange> range, Visit&& visit,
                           parallel::Cut::Where where) {
    parallel::for_each(
        chunks_.size(),
        [&](std::size_t c) {
            thread_local BlockOfCells cells;
            const Chunk& chunk = chunks_[c];
            for (const Block& block : chunk.blocks) {
                cells.begin(grid_, block.number);
                for (std::size_t k = block.facet; k < block.facet + block.facets; ++k)
                    cells.enter(chunk.facets[k], range[chunk.facets[k]]);
                visit(block, cells);
            }
        },
        parallel::Cut(1, where));
}

inline contact::Box FacetBlocks::box(std::size_t number, const contact::Box& all,
                                     double more) const {
    const auto& count = blocks_.count;
    const auto row = static_cast<int>(number);
    const std::array<int, 3> at{row % count[0], row / count[0] % count[1],
                                row / (count[0] * count[1])};
    contact::Box box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = blocks_.low[a] + blocks_.edge * at[a] - more;
        box.high[a] = blocks_.low[a] + blocks_.edge * (at[a] + 1) + more;
        if (at[a] == 0) box.low[a] = std::min(box.low[a], all.low[a]);
        if (at[a] + 1 == count[a]) box.high[a] = std::max(box.high[a], all.high[a]);
    }
    return box;
}

}  // namespace corpuscle::gas
