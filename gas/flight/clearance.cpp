// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/clearance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t MOST_CLEARANCE_CELLS = 1'000'000;

constexpr std::size_t CLEARANCE_CELLS_A_CHUNK = 4096;

/// Of a cell's edge: nearer than this to its faces, single precision may be wrong about the cell.
constexpr double ON_A_CELL_FACE = 1e-4;

/// Of the grid's size: heights and ways in single precision may be wrong by less.
constexpr double CLEARANCE_ROUNDING = 2e-6;

/// Cells to the next with facets, from which on it is not worth knowing how many.
constexpr std::uint8_t FAR = 5;

/// A little more, so that normals sum up to no more than one.
float sum_of_magnitudes(const std::array<float, 3>& a) {
    return (std::abs(a[0]) + std::abs(a[1]) + std::abs(a[2])) * (1.0F + 1e-6F);
}

}  // namespace

void Clearance::build(std::span<const Triangle> triangles, std::span<const Vec3> x,
                      const FacetPatches& patches, const Grid& within, double edge, double reach) {
    row_.clear();
    if (!(reach > 0.0)) return;
    const Vec3 size = within.edge * Vec3(within.count[0], within.count[1], within.count[2]);
    grid_ = Grid::over(within.low, within.low + size, edge, MOST_CLEARANCE_CELLS);
    per_edge_ = static_cast<float>(grid_.per_edge);
    const double rounding =
        CLEARANCE_ROUNDING * grid_.edge * *std::max_element(grid_.count.begin(), grid_.count.end());
    reach_ = static_cast<float>(reach - rounding);

    const double around = reach_ * (1.0 + 1e-6) + ON_A_CELL_FACE * grid_.edge;
    range_.resize(triangles.size());
    parallel::for_each(
        triangles.size(),
        [&](std::size_t f) {
            range_[f] = CellRange::of(grid_, contact::triangle_box(triangles[f], x, x, around));
        },
        parallel::CHUNK);
    off_.resize(grid_.size());
    blocks_.find(grid_, patches, around, range_, {},
                 [&](const FacetBlocks::Block&, BlockOfCells& block) {
                     block.for_each_row([&](std::size_t row) { off_[row] = FAR; });
                     for (const int cell : block.cells()) off_[block.row(cell)] = 0;
                 });
    number_cells();
    free_.clear();
    for (int k = 0; k < FAR; ++k)
        free_.push_back(reach_ + static_cast<float>((1.0 - ON_A_CELL_FACE) * k * grid_.edge));
    blocks_.for_each(range_, [&](const FacetBlocks::Block&, BlockOfCells& block) {
        block.sort();
        block.take_corners(triangles, x, x);
        for (const int cell : block.cells()) {
            SafeSlab& slab = slab_[row_[block.row(cell)]];
            static_cast<Planes&>(slab) = block.planes(cell, sum_of_magnitudes);
            slab.low -= static_cast<float>(rounding);
            slab.high += static_cast<float>(rounding);
        }
    });
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
    std::vector<Index> slabs(parallel::chunk_count(grid_.size(), CLEARANCE_CELLS_A_CHUNK) + 1, 0);
    const auto count = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        const auto first = off_.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = off_.begin() + static_cast<std::ptrdiff_t>(end);
        slabs[chunk + 1] = static_cast<Index>(std::count(first, last, 0));
    };
    const auto number = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Index next = slabs[chunk];
        for (std::size_t cell = begin; cell < end; ++cell)
            row_[cell] = off_[cell] == 0 ? next++ : -static_cast<Index>(off_[cell]);
    };
    parallel::for_chunks(grid_.size(), count, CLEARANCE_CELLS_A_CHUNK);
    std::partial_sum(slabs.begin(), slabs.end(), slabs.begin());
    parallel::for_chunks(grid_.size(), number, CLEARANCE_CELLS_A_CHUNK);
    slab_.resize(static_cast<std::size_t>(slabs.back()));  // all are written
}

}  // namespace corpuscle::gas
