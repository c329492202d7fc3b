// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/facet_lists.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr int BLOCK =
    8;  ///< cells along a block's edge; smaller: tighter pairs, more boxes for FCL

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
                       double margin) {
    ++builds_;
    margin_ = margin;
    built_at_.resize(nodes_.size());
    for (std::size_t n = 0; n < nodes_.size(); ++n) built_at_[n] = x_1[nodes_[n]];
    grid_ = grid;
    for (std::size_t f = 0; f < triangles_.size(); ++f)
        facet_box_[f] = contact::triangle_box(triangles_[f], x_0, x_1, margin);
    pair_patches_with_blocks();

    start_.assign(grid_.size() + 1, 0);
    for_each_entry([&](std::size_t cell, Index) { ++start_[cell + 1]; });
    for (std::size_t c = 0; c < grid_.size(); ++c) start_[c + 1] += start_[c];
    facet_.resize(static_cast<std::size_t>(start_.back()));
    fill_.assign(start_.begin(), start_.end() - 1);
    for_each_entry([&](std::size_t cell, Index facet) { facet_[fill_[cell]++] = facet; });
    measure_clearance();
    find_slabs(x_0, x_1);
}

/// Cells with facets grow by one cell a pass, along each axis in turn.
void FacetLists::measure_clearance() {
    clear_.assign(grid_.size(), FAR);
    for (std::size_t c = 0; c < grid_.size(); ++c)
        if (start_[c] != start_[c + 1]) clear_[c] = 0;
    const auto [nx, ny, nz] = grid_.count;
    const std::array<std::ptrdiff_t, 3> stride{1, nx, static_cast<std::ptrdiff_t>(nx) * ny};
    for (int pass = 1; pass < FAR; ++pass) {
        const auto value = static_cast<std::uint8_t>(pass);
        for (int axis = 0; axis < 3; ++axis) {
            wider_ = clear_;
            std::size_t c = 0;
            for (int k = 0; k < nz; ++k)
                for (int j = 0; j < ny; ++j)
                    for (int i = 0; i < nx; ++i, ++c) {
                        const int at = axis == 0 ? i : axis == 1 ? j : k;
                        const bool is_near =
                            (at > 0 && clear_[c - stride[axis]] <= value - (axis == 0)) ||
                            (at + 1 < grid_.count[axis] &&
                             clear_[c + stride[axis]] <= value - (axis == 0));
                        if (is_near) wider_[c] = std::min(wider_[c], value);
                    }
            clear_.swap(wider_);
        }
    }
}

/// Normals: the mean of the facets', turned alike. Heights: of all nodes, and the margin.
void FacetLists::find_slabs(std::span<const Vec3> x_0, std::span<const Vec3> x_1) {
    normal_.resize(triangles_.size());
    parallel::for_each(triangles_.size(), [&](std::size_t f) {
        const auto& [a, b, c] = triangles_[f];
        normal_[f] = vector_area(x_1[a], x_1[b], x_1[c]);
    });
    slab_.resize(grid_.size());
    parallel::for_each(grid_.size(), [&](std::size_t cell) {
        if (start_[cell] == start_[cell + 1]) return;
        const auto facets = in(cell);
        const Vec3 first = normal_[facets[0]];
        Vec3 sum = Vec3::Zero();
        for (const Index f : facets)
            sum += normal_[f].dot(first) < 0.0 ? Vec3(-normal_[f]) : normal_[f];
        Slab& slab = slab_[cell];
        slab.normal = sum.stableNormalized();
        slab.low = INF;
        slab.high = -INF;
        for (const Index f : facets)
            for (const Index n : triangles_[f]) {
                const double h_0 = slab.normal.dot(x_0[n]), h_1 = slab.normal.dot(x_1[n]);
                slab.low = std::min({slab.low, h_0, h_1});
                slab.high = std::max({slab.high, h_0, h_1});
            }
        const double more = margin_ * slab.normal.lpNorm<1>() + 1e-9 * grid_.edge;
        slab.low -= more;
        slab.high += more;
    });
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
