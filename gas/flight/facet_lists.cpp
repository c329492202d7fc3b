// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/facet_lists.hpp"

#include <algorithm>
#include <utility>

#include "gas/flight/each_block.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Cells of the table of safe distances, in cells of the lists. Smaller: tighter planes, more cells.
constexpr double CLEARANCE_CELL = 2.0 / 3.0;

/// Of a cell's edge: nearer than this to its faces, single precision may be wrong about the cell.
constexpr double ON_THE_FACE = 1e-4;

/// Of the grid's size: heights in single precision may be wrong by less.
constexpr double ROUNDING = 2e-6;

constexpr std::size_t PATCHES_A_CHUNK = 2;  ///< some hundred facets

/// Without squares that a small unit of length would bring to naught.
float length(const std::array<float, 3>& a) {
    const float most = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
    if (!(most > 0.0F)) return 0.0F;
    const float x = a[0] / most, y = a[1] / most, z = a[2] / most;
    return most * std::sqrt(x * x + y * y + z * z);
}

/// Box of a block of cells; what lies beyond the grid, up to `all`, belongs to the outermost ones.
contact::Box block_box(const Grid& blocks, const std::array<int, 3>& at, const contact::Box& all) {
    contact::Box box;
    for (int a = 0; a < 3; ++a) {
        box.low[a] = blocks.low[a] + blocks.edge * at[a];
        box.high[a] = box.low[a] + blocks.edge;
        if (at[a] == 0) box.low[a] = std::min(box.low[a], all.low[a]);
        if (at[a] + 1 == blocks.count[a]) box.high[a] = std::max(box.high[a], all.high[a]);
    }
    return box;
}

std::vector<Index> nodes_of(const std::vector<Triangle>& triangles) {
    std::vector<Index> nodes;
    for (const Triangle& t : triangles) nodes.insert(nodes.end(), t.begin(), t.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

FacetLists::FacetLists(std::vector<Triangle> triangles, std::span<const Vec3> x, Of of)
    : triangles_(std::move(triangles)),
      nodes_(nodes_of(triangles_)),
      patches_(contact::make_patches(x, triangles_)),
      eights_(make_eights(x, triangles_, patches_)),
      of_(of),
      range_(triangles_.size()) {}

bool FacetLists::hold_for(std::span<const Vec3> x_1) const {
    if (margin_ < 0.0) return false;
    using Flag = std::uint8_t;
    return parallel::fold(
               nodes_.size(), Flag{1},
               [&](Flag& holds, std::size_t n) {
                   holds &= (x_1[nodes_[n]] - built_at_[n]).cwiseAbs().maxCoeff() <= margin_;
               },
               [](Flag& all, Flag holds) { all &= holds; }) != 0;
}

double FacetLists::displacement(std::span<const Vec3> x_0, std::span<const Vec3> x_1) const {
    return parallel::fold(
               nodes_.size(), Vec3(Vec3::Zero()),
               [&](Vec3& most, std::size_t n) {
                   most = most.cwiseMax((x_0[nodes_[n]] - built_at_[n]).cwiseAbs())
                              .cwiseMax((x_1[nodes_[n]] - built_at_[n]).cwiseAbs());
               },
               [](Vec3& all, const Vec3& most) { all = all.cwiseMax(most); })
        .maxCoeff();
}

void FacetLists::build(const Grid& grid, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
                       double margin, double reach) {
    ++builds_;
    margin_ = margin;
    per_edge_ = static_cast<float>(grid.per_edge);
    moved_between_builds_ = built_at_.empty() ? INF : displacement(x_1, x_1);
    built_at_.resize(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) built_at_[n] = x_1[nodes_[n]];
    grid_ = grid;
    size_ = grid_.edge * *std::max_element(grid_.count.begin(), grid_.count.end());
    pair_blocks_with_patches(x_0, x_1);

    // Room first: entries and slabs of each block, then where each block's begin.
    for_each_block(block_.size() - 1, [&](std::size_t b, BlockOfCells& block) {
        enter(b, block);
        block_[b].entry = of_ == Of::FACETS ? block.entries() : block.eights_by_eight();
        block_[b].slab = block.cells().size();
    });
    std::size_t entries = 0, slabs = 1;
    for (CellBlock& b : block_) {
        entries += std::exchange(b.entry, entries);
        slabs += std::exchange(b.slab, slabs);
    }
    facet_.resize(of_ == Of::FACETS ? entries : 0);
    eights_in_.resize(of_ == Of::EIGHTS ? entries : 0);
    slab_.resize(slabs);
    slab_[0] = {};
    slab_row_.assign(grid_.size(), 0);
    for_each_block(block_.size() - 1,
                   [&](std::size_t b, BlockOfCells& block) { fill(b, x_0, x_1, block); });
    clearance_.build(triangles_, x_1, grid, CLEARANCE_CELL * grid.edge, reach);
}

/// All facets of a block's patches.
void FacetLists::enter(std::size_t number, BlockOfCells& block) const {
    const std::size_t first = block_[number].pair;
    block.begin(grid_, static_cast<std::size_t>(pairs_[first].first));
    for (std::size_t p = first; p < block_[number + 1].pair; ++p)
        for (const Index facet : patches_[static_cast<std::size_t>(pairs_[p].second)])
            block.enter(facet, range_[facet], eights_.of[facet]);
}

/// Writes a block's facets and slabs. Heights are those of all nodes, and the margin.
void FacetLists::fill(std::size_t number, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
                      BlockOfCells& block) {
    enter(number, block);
    block.sort();
    block.take_corners(triangles_, x_0, x_1);
    std::size_t to = block_[number].entry, row = block_[number].slab;
    for (const int cell : block.cells()) {
        Slab& slab = slab_[row];
        slab_row_[block.row(cell)] = static_cast<Index>(row++);
        slab.begin = static_cast<Index>(to);
        if (of_ == Of::FACETS)
            for (const std::int32_t place : block.in(cell)) facet_[to++] = block.facet(place);
        else
            to = list_eights(cell, block, to);
        slab.end = static_cast<Index>(to);
        const Planes planes = block.planes(cell, length);
        const auto& n = planes.normal;
        const double all = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
        const double more = margin_ * all + ROUNDING * size_;
        slab.normal = n;
        slab.low = static_cast<float>(planes.low - more);
        slab.high = static_cast<float>(planes.high + more);
    }
}

/// Writes a cell's eights from entry `to` on; those of an eight have been entered together.
/// @returns the next entry
std::size_t FacetLists::list_eights(int cell, const BlockOfCells& block, std::size_t to) {
    int lane = EIGHT;
    Index last = -1;
    for (const std::int32_t place : block.in(cell)) {
        const Index eight = eights_.of[block.facet(place)];
        if (std::exchange(last, eight) == eight) continue;
        if (lane == EIGHT) {
            eights_in_[to++].fill(-1);
            lane = 0;
        }
        eights_in_[to - 1][lane++] = eight;
    }
    return to;
}

/// By FCL. Ranges of facets on the way.
void FacetLists::pair_blocks_with_patches(std::span<const Vec3> x_0, std::span<const Vec3> x_1) {
    const double around = margin_ + ON_THE_FACE * grid_.edge;
    box_.assign(patches_.size(), {});
    parallel::for_each(
        patches_.size(),
        [&](std::size_t p) {
            for (const Index facet : patches_[p]) {
                const contact::Box box = contact::triangle_box(triangles_[facet], x_0, x_1, around);
                range_[facet] = CellRange::of(grid_, box);
                box_[p].include(box);
            }
        },
        PATCHES_A_CHUNK);
    patch_tree_.update(box_);

    const Grid blocks = BlockOfCells::blocks_of(grid_);
    contact::Box all;
    for (const contact::Box& box : box_) all.include(box);
    box_.clear();
    for (int k = 0; k < blocks.count[2]; ++k)
        for (int j = 0; j < blocks.count[1]; ++j)
            for (int i = 0; i < blocks.count[0]; ++i)
                box_.push_back(block_box(blocks, {i, j, k}, all));
    block_tree_.update(box_);
    block_tree_.pairs(patch_tree_, pairs_);
    block_.clear();
    for (std::size_t p = 0; p < pairs_.size(); ++p)
        if (p == 0 || pairs_[p].first != pairs_[p - 1].first) block_.push_back({p, 0, 0});
    block_.push_back({pairs_.size(), 0, 0});
}

}  // namespace corpuscle::gas
