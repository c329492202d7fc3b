// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/facet_lists.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr int BLOCK =
    8;  ///< cells along a block's edge; smaller: tighter pairs, more boxes for FCL

/// Cells of the table of free ways, in cells of the lists. Smaller: tighter planes, more cells.
constexpr double CLEARANCE_CELL = 1.0;

/// Of a cell's edge: nearer than this to its faces, single precision may be wrong about the cell.
constexpr double ON_THE_FACE = 1e-4;

/// Of the grid's size: heights in single precision may be wrong by less.
constexpr double ROUNDING = 2e-6;

std::vector<Index> nodes_of(const std::vector<Triangle>& triangles) {
    std::vector<Index> nodes;
    for (const Triangle& t : triangles) nodes.insert(nodes.end(), t.begin(), t.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

}  // namespace

FacetLists::FacetLists(std::vector<Triangle> triangles, std::span<const Vec3> x)
    : triangles_(std::move(triangles)),
      nodes_(nodes_of(triangles_)),
      patches_(contact::make_patches(x, triangles_)),
      facet_box_(triangles_.size()) {}

bool FacetLists::hold_for(std::span<const Vec3> x_1) const {
    if (margin_ < 0.0) return false;
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (!((x_1[nodes_[n]] - built_at_[n]).cwiseAbs().maxCoeff() <= margin_)) return false;
    return true;
}

void FacetLists::build(const Grid& grid, std::span<const Vec3> x_0, std::span<const Vec3> x_1,
                       double margin, double reach) {
    ++builds_;
    margin_ = margin;
    per_edge_ = static_cast<float>(grid.per_edge);
    const double around = margin + ON_THE_FACE * grid.edge;
    moved_between_builds_ = built_at_.empty() ? INF : displacement(x_1, x_1);
    built_at_.resize(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) built_at_[n] = x_1[nodes_[n]];
    grid_ = grid;
    for (std::size_t f = 0; f < triangles_.size(); ++f)
        facet_box_[f] = contact::triangle_box(triangles_[f], x_0, x_1, around);
    pair_patches_with_blocks();

    start_.assign(grid_.size() + 1, 0);
    for_each_entry([&](std::size_t cell, Index) { ++start_[cell + 1]; });
    for (std::size_t c = 0; c < grid_.size(); ++c) start_[c + 1] += start_[c];
    facet_.resize(static_cast<std::size_t>(start_.back()));
    fill_.assign(start_.begin(), start_.end() - 1);
    for_each_entry([&](std::size_t cell, Index facet) { facet_[fill_[cell]++] = facet; });
    find_slabs(x_0, x_1);
    clearance_.build(triangles_, x_1, grid, CLEARANCE_CELL * grid.edge, reach);
}

/// Normals: the mean of the facets', turned alike. Heights: of all nodes, and the margin.
void FacetLists::find_slabs(std::span<const Vec3> x_0, std::span<const Vec3> x_1) {
    normal_.resize(triangles_.size());
    parallel::for_each(triangles_.size(), [&](std::size_t f) {
        const auto& [a, b, c] = triangles_[f];
        normal_[f] = vector_area(x_1[a], x_1[b], x_1[c]);
    });
    slab_row_.assign(grid_.size(), 0);
    Index rows = 1;
    for (std::size_t cell = 0; cell < grid_.size(); ++cell)
        if (!is_empty(cell)) slab_row_[cell] = rows++;
    slab_.assign(static_cast<std::size_t>(rows), {});
    size_ = grid_.edge * *std::max_element(grid_.count.begin(), grid_.count.end());
    parallel::for_each(
        grid_.size(),
        [&](std::size_t cell) {
            if (is_empty(cell)) return;
            const auto facets = in(cell);
            const Vec3 first = normal_[facets[0]];
            Vec3 sum = Vec3::Zero();
            for (const Index f : facets)
                sum += normal_[f].dot(first) < 0.0 ? Vec3(-normal_[f]) : normal_[f];
            const Vec3 normal = sum.stableNormalized().cast<float>().cast<double>();
            double low = INF, high = -INF;
            for (const Index f : facets)
                for (const Index n : triangles_[f])
                    for (const Vec3& x : {x_0[n], x_1[n]}) {
                        const double height = normal.dot(x - grid_.low);
                        low = std::min(low, height);
                        high = std::max(high, height);
                    }
            const double more = margin_ * normal.lpNorm<1>() + ROUNDING * size_;
            Slab& slab = slab_[slab_row_[cell]];
            for (int a = 0; a < 3; ++a) slab.normal[a] = static_cast<float>(normal[a]);
            slab.low = static_cast<float>(low - more);
            slab.high = static_cast<float>(high + more);
            slab.begin = start_[cell];
            slab.end = start_[cell + 1];
        },
        parallel::CHUNK);
}

void FacetLists::pair_patches_with_blocks() {
    box_.assign(patches_.size(), {});
    for (std::size_t p = 0; p < patches_.size(); ++p)
        for (const Index facet : patches_[p]) box_[p].include(facet_box_[facet]);
    patch_tree_.update(box_);

    blocks_ = grid_;
    for (int& n : blocks_.count) n = (n + BLOCK - 1) / BLOCK;
    box_.clear();
    for (int k = 0; k < blocks_.count[2]; ++k)
        for (int j = 0; j < blocks_.count[1]; ++j)
            for (int i = 0; i < blocks_.count[0]; ++i) {
                const double edge = BLOCK * grid_.edge;
                const Vec3 low = grid_.low + edge * Vec3(i, j, k);
                box_.push_back({low, low + Vec3::Constant(edge)});
            }
    block_tree_.update(box_);
    patch_tree_.pairs(block_tree_, pairs_);
}

/// enter(cell, facet) for each facet of each paired patch, in the cells of the paired block.
template <class Enter>
void FacetLists::for_each_entry(Enter&& enter) const {
    for (const auto& [patch, block] : pairs_) {
        const std::array<int, 3> at{block % blocks_.count[0],
                                    block / blocks_.count[0] % blocks_.count[1],
                                    block / (blocks_.count[0] * blocks_.count[1])};
        for (const Index facet : patches_[patch]) {
            std::array<int, 3> from, to;
            for (int a = 0; a < 3; ++a) {
                from[a] = std::max(grid_.along(a, facet_box_[facet].low[a]), at[a] * BLOCK);
                to[a] = std::min({grid_.along(a, facet_box_[facet].high[a]),
                                  at[a] * BLOCK + BLOCK - 1, grid_.count[a] - 1});
            }
            for (int k = from[2]; k <= to[2]; ++k)
                for (int j = from[1]; j <= to[1]; ++j)
                    for (int i = from[0]; i <= to[0]; ++i) enter(grid_.row(i, j, k), facet);
        }
    }
}

}  // namespace corpuscle::gas
