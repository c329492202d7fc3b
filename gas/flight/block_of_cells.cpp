// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/flight/block_of_cells.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/simd.hpp"

namespace corpuscle::gas {
namespace {

/// visit(cell of the block) for a range within it.
template <class Visit>
void for_each_cell(const CellRange& range, Visit&& visit) {
    constexpr int EDGE = BlockOfCells::EDGE;
    for (int k = range.from[2]; k <= range.to[2]; ++k)
        for (int j = range.from[1]; j <= range.to[1]; ++j)
            for (int i = range.from[0]; i <= range.to[0]; ++i) visit((k * EDGE + j) * EDGE + i);
}

}  // namespace

void BlockOfCells::begin(const Grid& grid, std::size_t block) {
    grid_ = &grid;
    const Grid blocks = blocks_of(grid);
    const auto row = static_cast<int>(block);
    edge_ = edge_of(grid);
    first_ = {edge_ * (row % blocks.count[0]), edge_ * (row / blocks.count[0] % blocks.count[1]),
              edge_ * (row / (blocks.count[0] * blocks.count[1]))};
    entries_ = 0;
    entered_.clear();
    start_.fill(0);
    last_eight_.fill(-1);
    eights_.fill(0);
    cells_.clear();
}

void BlockOfCells::enter(Index facet, const CellRange& range, Index eight) {
    Entered one{facet, {}};
    for (int a = 0; a < 3; ++a) {
        one.range.from[a] = std::max(range.from[a] - first_[a], 0);
        one.range.to[a] = std::min(range.to[a] - first_[a], edge_ - 1);
        if (one.range.from[a] > one.range.to[a]) return;
    }
    entered_.push_back(one);
    for_each_cell(one.range, [&](int cell) {
        ++entries_;
        if (start_[cell + 1]++ == 0) cells_.push_back(cell);
        eights_[cell] += std::exchange(last_eight_[cell], eight) != eight;
    });
}

std::size_t BlockOfCells::eights_by_eight() const {
    constexpr Index EIGHT = corpuscle::EIGHT;
    Index blocks = 0;
    for (const int cell : cells_) blocks += (eights_[cell] + EIGHT - 1) / EIGHT;
    return static_cast<std::size_t>(blocks);
}

void BlockOfCells::sort() {
    std::sort(cells_.begin(), cells_.end());
    for (int c = 0; c < CELLS; ++c) start_[c + 1] += start_[c];
    std::array<std::int32_t, CELLS> next;
    std::copy(start_.begin(), start_.end() - 1, next.begin());
    sorted_.resize(entries_);
    for (std::size_t f = 0; f < entered_.size(); ++f)
        for_each_cell(entered_[f].range,
                      [&](int cell) { sorted_[next[cell]++] = static_cast<std::int32_t>(f); });
}

void BlockOfCells::take_corners(std::span<const Triangle> triangles, std::span<const Vec3> x_0,
                                std::span<const Vec3> x_1) {
    corners_.resize(entered_.size());
    for (std::size_t f = 0; f < entered_.size(); ++f) {
        const auto& [i, j, k] = triangles[entered_[f].facet];
        const Eigen::Vector3f normal = vector_area(x_1[i], x_1[j], x_1[k]).cast<float>();
        const auto at = [&](const Vec3& x) { return Vec3(x - grid_->low).cast<float>().eval(); };
        const std::array<Eigen::Vector3f, 6> x{at(x_0[i]), at(x_0[j]), at(x_0[k]),
                                               at(x_1[i]), at(x_1[j]), at(x_1[k])};
        FacetCorners& out = corners_[f];
        for (int a = 0; a < 3; ++a)
            out.along[a] =
                Eight{x[0][a], x[1][a], x[2][a], x[3][a], x[4][a], x[5][a], x[0][a], x[0][a]};
        out.normal = Quad{normal[0], normal[1], normal[2], 0.0F};
    }
}

}  // namespace corpuscle::gas
