// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/facet_lists.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// Cells of the table of safe distances, in cells of the lists. Smaller: tighter planes, more cells.
constexpr double CLEARANCE_CELL = 2.0 / 3.0;

/// Of a cell's edge: nearer than this to its faces, single precision may be wrong about the cell.
constexpr double ON_THE_FACE = 1e-4;

/// Of the grid's size: heights in single precision may be wrong by less.
constexpr double ROUNDING = 2e-6;

/// Without squares that a small unit of length would bring to naught.
float length(const std::array<float, 3>& a) {
    const float most = std::max({std::abs(a[0]), std::abs(a[1]), std::abs(a[2])});
    if (!(most > 0.0F)) return 0.0F;
    const float x = a[0] / most, y = a[1] / most, z = a[2] / most;
    return most * std::sqrt(x * x + y * y + z * z);
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
      patches_(triangles_, x),
      eights_(make_eights(x, triangles_, patches_.patches())),
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
    parallel::for_each(nodes_.size(), [&](std::size_t n) { built_at_[n] = x_1[nodes_[n]]; });
    grid_ = grid;
    size_ = grid_.edge * *std::max_element(grid_.count.begin(), grid_.count.end());
    const double around = margin_ + ON_THE_FACE * grid_.edge;
    patches_.update(triangles_, x_0, x_1, around, [&](Index facet, const contact::Box& box) {
        range_[facet] = CellRange::of(grid_, box);
    });

    // Room first: entries and slabs of each block, then where each block's begin.
    slab_row_.resize(grid_.size());
    blocks_.find(grid_, patches_, around, range_, eights_.of,
                 [&](FacetBlocks::Block& block, BlockOfCells& cells) {
                     block.entry = of_ == Of::FACETS ? cells.entries() : cells.eights_by_eight();
                     block.slab = cells.cells().size();
                     cells.for_each_row([&](std::size_t row) { slab_row_[row] = 0; });
                 });
    std::size_t entries = 0, slabs = 1;
    blocks_.for_each_in_turn([&](FacetBlocks::Block& block) {
        entries += std::exchange(block.entry, entries);
        slabs += std::exchange(block.slab, slabs);
    });
    facet_.resize(of_ == Of::FACETS ? entries : 0);
    eights_in_.resize(of_ == Of::EIGHTS ? entries : 0);
    slab_.resize(slabs);
    slab_[0] = {};
    blocks_.for_each(range_, [&](const FacetBlocks::Block& block, BlockOfCells& cells) {
        fill(block, x_0, x_1, cells);
    });
    clearance_.build(triangles_, x_1, patches_, grid, CLEARANCE_CELL * grid.edge, reach);
}

/// Writes a block's facets and slabs. Heights are those of all nodes, and the margin.
void FacetLists::fill(const FacetBlocks::Block& at, std::span<const Vec3> x_0,
                      std::span<const Vec3> x_1, BlockOfCells& block) {
    block.sort();
    block.take_corners(triangles_, x_0, x_1);
    std::size_t to = at.entry, row = at.slab;
    for (const int cell : block.cells()) {
        Slab& slab = slab_[row];
        slab_row_[block.row(cell)] = static_cast<Index>(row++);
        slab.begin = static_cast<Index>(to);
        if (of_ == Of::FACETS)
            for (const std::int32_t place : block.in(cell))
                facet_[to++] = block.facet(static_cast<std::size_t>(place));
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
        const Index eight = eights_.of[block.facet(static_cast<std::size_t>(place))];
        if (std::exchange(last, eight) == eight) continue;
        if (lane == EIGHT) {
            eights_in_[to++].fill(-1);
            lane = 0;
        }
        eights_in_[to - 1][lane++] = eight;
    }
    return to;
}

}  // namespace corpuscle::gas
