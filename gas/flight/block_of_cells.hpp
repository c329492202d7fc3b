// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/geometry/box.hpp"
#include "gas/grid.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

/// Cells of a grid that a box overlaps, both ends included.
struct CellRange {
    std::array<int, 3> from, to;

    static CellRange of(const Grid& grid, const contact::Box& box) {
        CellRange out;
        for (int a = 0; a < 3; ++a) {
            out.from[a] = grid.along(a, box.low[a]);
            out.to[a] = grid.along(a, box.high[a]);
        }
        return out;
    }
};

/// Two parallel planes that facets lie between: low <= normal·x <= high, x from the grid's corner.
struct Planes {
    std::array<float, 3> normal{0.0F, 0.0F, 0.0F};  ///< not of unit length
    float low = 0.0F, high = 0.0F;
};

/// The facets of 3 × 3 × 3 cells (of a coarse grid: of one), sorted into them: what one thread does
/// while lists are built.
///
///     block.begin(grid, row);
///     for (facets that may be in it) block.enter(facet, cells it overlaps);
///     block.sort();
///     for (int c : block.cells()) ... block.row(c), block.in(c)
class BlockOfCells {
public:
    static constexpr int EDGE = 3;  ///< cells; smaller: tighter pairs, more questions to FCL
    static constexpr int CELLS = EDGE * EDGE * EDGE;

    /// A grid's blocks.
    static Grid blocks_of(const Grid& grid) {
        const int edge = edge_of(grid);
        Grid blocks = grid;
        blocks.set_edge(edge * grid.edge);
        for (int& n : blocks.count) n = (n + edge - 1) / edge;
        return blocks;
    }
    /// Edge of a grid's blocks.                                                           [cells]
    static int edge_of(const Grid& grid) {
        constexpr std::size_t COARSE = 1000;  // cells: what holds many facets is shared out
        return grid.size() <= COARSE ? 1 : EDGE;
    }

    void begin(const Grid& grid, std::size_t block);
    /// A cell's eights are counted where those of an eight are entered one after another.
    void enter(Index facet, const CellRange& range, Index eight = 0);
    /// Facets stay in the order in which they were entered.
    void sort();

    [[nodiscard]] std::size_t entries() const { return entries_; }
    /// Of all cells, blocks that hold each cell's eights by EIGHT.
    [[nodiscard]] std::size_t eights_by_eight() const;
    /// Cells with facets, ascending.
    [[nodiscard]] std::span<const int> cells() const { return cells_; }
    [[nodiscard]] std::size_t row(int cell) const {
        return grid_->row(first_[0] + cell % EDGE, first_[1] + cell / EDGE % EDGE,
                          first_[2] + cell / (EDGE * EDGE));
    }
    /// visit(row) for each cell of the block that the grid has.
    template <class Visit>
    void for_each_row(Visit&& visit) const {
        std::array<int, 3> end;
        for (int a = 0; a < 3; ++a) end[a] = std::min(first_[a] + edge_, grid_->count[a]);
        for (int k = first_[2]; k < end[2]; ++k)
            for (int j = first_[1]; j < end[1]; ++j)
                for (int i = first_[0]; i < end[0]; ++i) visit(grid_->row(i, j, k));
    }
    /// Facets of a cell, by their places among those entered. After sort().
    [[nodiscard]] std::span<const std::int32_t> in(int cell) const {
        return {sorted_.data() + start_[cell],
                static_cast<std::size_t>(start_[cell + 1] - start_[cell])};
    }
    [[nodiscard]] Index facet(std::size_t place) const { return entered_[place].facet; }
    [[nodiscard]] std::size_t entered() const { return entered_.size(); }  ///< facets

    /// Reads the entered facets' corners, at x_0 and x_1.
    void take_corners(std::span<const Triangle> triangles, std::span<const Vec3> x_0,
                      std::span<const Vec3> x_1);
    /// Planes of a cell's facets along their mean normal, all turned alike, whose size() comes out
    /// as one.
    template <class Size>
    [[nodiscard]] Planes planes(int cell, Size&& size) const;

private:
    using Eight = float __attribute__((vector_size(32)));
    using Quad = float __attribute__((vector_size(16)));
    struct Entered {
        Index facet;
        CellRange range;  ///< within the block
    };
    /// Three corners at t, three at t + dt, the first again, and again.
    struct FacetCorners {
        std::array<Eight, 3> along;
        Quad normal;  ///< at t + dt, of no particular length
    };

    const Grid* grid_ = nullptr;
    int edge_ = EDGE;             ///< cells
    std::array<int, 3> first_{};  ///< cell
    std::size_t entries_ = 0;
    std::array<Index, CELLS> last_eight_{}, eights_{};  ///< by cell: entered last; so far
    std::vector<Entered> entered_;
    std::vector<FacetCorners> corners_;
    std::array<std::int32_t, CELLS + 1> start_{};  ///< until sort(): facets in the cell before
    std::vector<std::int32_t> sorted_;
    std::vector<int> cells_;
};

template <class Size>
Planes BlockOfCells::planes(int cell, Size&& size) const {
    const auto facets = in(cell);
    const Quad first = corners_[facets[0]].normal;
    Quad sum{};
    for (const std::int32_t f : facets) {
        const Quad n = corners_[f].normal, product = n * first;
        sum += product[0] + product[1] + product[2] < 0.0F ? -n : n;
    }
    const std::array<float, 3> mean{sum[0], sum[1], sum[2]};
    const float all = size(mean);
    Planes out;
    for (int a = 0; a < 3; ++a) out.normal[a] = all > 0.0F ? mean[a] / all : 0.0F;
    Eight low{}, high{};
    low += static_cast<float>(INF);
    high -= static_cast<float>(INF);
    for (const std::int32_t f : facets) {
        const auto& [x, y, z] = corners_[f].along;
        const Eight height = out.normal[0] * x + out.normal[1] * y + out.normal[2] * z;
        low = height < low ? height : low;
        high = height > high ? height : high;
    }
    out.low = low[0];
    out.high = high[0];
    for (int i = 1; i < 6; ++i) {
        out.low = std::min(out.low, low[i]);
        out.high = std::max(out.high, high[i]);
    }
    return out;
}

}  // namespace corpuscle::gas
