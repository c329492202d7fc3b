// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/clearance.hpp"

#include <limits>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t MOST_CELLS = 1'000'000;

/// Of a cell's edge: nearer than this to its faces, single precision may be wrong about the cell.
constexpr double ON_THE_FACE = 1e-4;

/// Of the grid's size: heights and ways in single precision may be wrong by less.
constexpr double ROUNDING = 2e-6;

/// Cells to the next with facets, from which on it is not worth knowing how many.
constexpr std::uint8_t FAR = 5;

}  // namespace

void Clearance::build(std::span<const Triangle> triangles, std::span<const Vec3> x,
                      const Grid& within, double edge, double reach) {
    row_.clear();
    if (!(reach > 0.0)) return;
    const Vec3 size = within.edge * Vec3(within.count[0], within.count[1], within.count[2]);
    grid_ = Grid::over(within.low, within.low + size, edge, MOST_CELLS);
    per_edge_ = static_cast<float>(grid_.per_edge);
    const double rounding =
        ROUNDING * grid_.edge * *std::max_element(grid_.count.begin(), grid_.count.end());
    reach_ = static_cast<float>(reach - rounding);

    off_.assign(grid_.size(), FAR);
    for_each_entry(triangles, x, [&](std::size_t cell, std::size_t) { off_[cell] = 0; });
    number_cells();
    free_.clear();
    for (int k = 0; k < FAR; ++k)
        free_.push_back(reach_ + static_cast<float>((1.0 - ON_THE_FACE) * k * grid_.edge));

    // Normals: the mean of the facets', turned alike. Heights: of all nodes.
    for_each_entry(triangles, x, [&](std::size_t cell, std::size_t facet) {
        const auto& [i, j, k] = triangles[facet];
        const Eigen::Vector3f normal = vector_area(x[i], x[j], x[k]).cast<float>();
        auto& sum = slab_[row_[cell]].normal;
        const bool is_turned = normal[0] * sum[0] + normal[1] * sum[1] + normal[2] * sum[2] < 0.0F;
        for (int a = 0; a < 3; ++a) sum[a] += is_turned ? -normal[a] : normal[a];
    });
    for (Slab& slab : slab_) {
        const auto& n = slab.normal;
        const float all = std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]);
        for (float& a : slab.normal) a = all > 0.0F ? a / all * (1.0F - 1e-6F) : 0.0F;
        slab.low = std::numeric_limits<float>::max();
        slab.high = -slab.low;
    }
    for_each_entry(triangles, x, [&](std::size_t cell, std::size_t facet) {
        Slab& slab = slab_[row_[cell]];
        for (const Index node : triangles[facet]) {
            const float h = slab.height(small(x[node]));
            slab.low = std::min(slab.low, h);
            slab.high = std::max(slab.high, h);
        }
    });
    for (Slab& slab : slab_) {
        slab.low -= static_cast<float>(rounding);
        slab.high += static_cast<float>(rounding);
    }
}

/// A cell whose nearest cell with facets is k cells off, counted along the axis where it is
/// farthest, is free for (k - 1) edges and the reach.
void Clearance::number_cells() {
    const std::array<std::size_t, 3> stride{
        1, static_cast<std::size_t>(grid_.count[0]),
        static_cast<std::size_t>(grid_.count[0]) * static_cast<std::size_t>(grid_.count[1])};
    for (int a = 0; a < 3; ++a) {
        off_before_ = off_;
        parallel::for_each(grid_.size(), [&](std::size_t cell) {
            const int here = static_cast<int>(cell / stride[a]) % grid_.count[a];
            for (int off = 1; off < off_[cell]; ++off) {
                const std::size_t far = static_cast<std::size_t>(off) * stride[a];
                std::uint8_t least = FAR;
                if (here >= off) least = off_before_[cell - far];
                if (here + off < grid_.count[a]) least = std::min(least, off_before_[cell + far]);
                off_[cell] = std::min(off_[cell], std::max<std::uint8_t>(least, off));
            }
        });
    }
    row_.resize(grid_.size());
    Index slabs = 0;
    for (std::size_t cell = 0; cell < grid_.size(); ++cell)
        row_[cell] = off_[cell] == 0 ? slabs++ : -static_cast<Index>(off_[cell]);
    slab_.assign(static_cast<std::size_t>(slabs), {});
}

/// enter(cell, facet) for each cell that a facet's box overlaps, by `reach` larger.
template <class Enter>
void Clearance::for_each_entry(std::span<const Triangle> triangles, std::span<const Vec3> x,
                               Enter&& enter) const {
    const Vec3 around = Vec3::Constant(reach_ * (1.0 + 1e-6) + ON_THE_FACE * grid_.edge);
    for (std::size_t f = 0; f < triangles.size(); ++f) {
        const auto& [a, b, c] = triangles[f];
        const Vec3 low = x[a].cwiseMin(x[b]).cwiseMin(x[c]) - around,
                   high = x[a].cwiseMax(x[b]).cwiseMax(x[c]) + around;
        std::array<int, 3> from, to;
        for (int k = 0; k < 3; ++k) {
            from[k] = grid_.along(k, low[k]);
            to[k] = grid_.along(k, high[k]);
        }
        for (int k = from[2]; k <= to[2]; ++k)
            for (int j = from[1]; j <= to[1]; ++j)
                for (int i = from[0]; i <= to[0]; ++i) enter(grid_.row(i, j, k), f);
    }
}

}  // namespace corpuscle::gas
