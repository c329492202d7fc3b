// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "gas/grid.hpp"
#include "gas/particles.hpp"

namespace corpuscle::gas {

/// Rows of particles in lists: list l holds order[start[l]] .. order[start[l + 1] - 1].
struct Lists {
    std::span<const Index> start;  ///< one more than there are lists
    std::span<const Index> order;  ///< particle rows

    [[nodiscard]] std::size_t size() const { return start.size() - 1; }
    [[nodiscard]] std::span<const Index> operator[](std::size_t l) const {
        return order.subspan(static_cast<std::size_t>(start[l]),
                             static_cast<std::size_t>(start[l + 1] - start[l]));
    }
};

/// Lists particles by grid cell, and now and then puts them in that order: neighbours in space
/// become neighbours in memory. A stable counting sort, so the order is that of cells, then of
/// rows, on any number of threads. Memory: 56 bytes a particle, 4 a cell and thread.
class CellSort {
public:
    /// Lists rows by cell; `moves_rows`: and puts the particles in that order. A few steps without
    /// leave neighbours near enough, and save most of the time.
    void sort(const Grid& grid, Particles& particles, bool moves_rows = true);

    /// Rows by cell, as sorted last.
    [[nodiscard]] Lists cells() const { return {start_, order_}; }
    /// The same, mutable, for further sorting of a cell's rows.
    [[nodiscard]] std::span<Index> order() { return order_; }

private:
    struct Column;
    [[nodiscard]] Index sum(std::size_t chunk, std::size_t slices) const;
    void share_out(std::size_t chunk, std::span<const Index> sums, std::size_t slices);
    void count(const Grid& grid, std::span<const Vec3> x, std::size_t slice);
    void place(std::size_t slice);
    void move_rows(Particles& particles);

    std::size_t cells_ = 0, slice_length_ = 1;
    std::vector<Index> cell_;  ///< of each particle
    std::vector<Index> fill_;  ///< slices × cells: first count, then next place
    std::vector<Index> start_;
    std::vector<Index> order_;  ///< rows
    static constexpr std::size_t SPARES = 2;
    std::array<std::vector<Vec3>, SPARES> spare_;
};

/// Edge of cubic cells that hold `per_cell` particles on average.                          [m]
inline double cell_edge(double volume, std::size_t particles, double per_cell) {
    return std::cbrt(volume * per_cell / static_cast<double>(particles));
}

}  // namespace corpuscle::gas
