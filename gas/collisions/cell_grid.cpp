// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/cell_grid.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <type_traits>
#include <utility>

#include "solver/base/parallel.hpp"
#include "solver/base/simd.hpp"

namespace corpuscle::gas {

namespace {

constexpr std::size_t SMALLEST_SLICE = 512;  ///< particles worth a thread
constexpr std::size_t SORTED_CELLS_A_CHUNK = 512;

/// Grid::cell_of() of many points, by fours.
void find_cells(const Grid& grid, std::span<const Vec3> x, Index* cell) {
    const std::size_t fours = x.size() / FOUR;
    for (std::size_t q = 0; q < fours; ++q) {
        const double* const at = x[q * FOUR].data();
        const auto column = columns(load_four(at), load_four(at + FOUR), load_four(at + 2 * FOUR));
        using Ints = std::int32_t __attribute__((vector_size(16)));
        std::array<Ints, 3> along;
        for (int a = 0; a < 3; ++a) {
            const Four cells = (column[a] - grid.low[a]) * grid.per_edge,
                       last = all_four(grid.count[a] - 1.0);
            const Four least = cells < 0.0 ? all_four(0.0) : cells;
            along[a] = __builtin_convertvector(least > last ? last : least, Ints);
        }
        const Ints row = (along[2] * grid.count[1] + along[1]) * grid.count[0] + along[0];
        std::memcpy(cell + q * FOUR, &row, sizeof(row));
    }
    for (std::size_t i = fours * FOUR; i < x.size(); ++i)
        cell[i] = static_cast<Index>(grid.cell_of(x[i]));
}

}  // namespace

/// One number or vector of each particle.
struct CellSort::Column {
    char* data;
    std::size_t size;          ///< of one [bytes]
    std::size_t ahead_of = 0;  ///< bytes of a particle in the columns before it in its stage

    template <class T>
    static Column of(std::vector<T>& column) {
        return {reinterpret_cast<char*>(column.data()), sizeof(T)};
    }
    /// Calls with a number of bytes that the compiler knows.
    template <class Copy>
    void by_size(Copy&& copy) const {
        if (size == 24) return copy(std::integral_constant<std::size_t, 24>());
        if (size == 8) return copy(std::integral_constant<std::size_t, 8>());
        if (size == 4) return copy(std::integral_constant<std::size_t, 4>());
        copy(std::integral_constant<std::size_t, 2>());
    }
    void gather(std::size_t begin, std::size_t end, std::span<const Index> order,
                std::vector<Vec3>& spare) const {
        by_size([&](auto bytes) {
            char* to = place(spare) + bytes * begin;
            for (std::size_t i = begin; i < end; ++i, to += bytes)
                std::memcpy(to, data + bytes * static_cast<std::size_t>(order[i]), bytes);
        });
    }
    void write(std::size_t begin, std::size_t end, std::vector<Vec3>& spare) const {
        std::memcpy(data + size * begin, place(spare) + size * begin, size * (end - begin));
    }

private:
    [[nodiscard]] char* place(std::vector<Vec3>& spare) const {
        return reinterpret_cast<char*>(spare.data()) + ahead_of * spare.size();
    }
};

void CellSort::sort(const Grid& grid, Particles& particles, bool moves_rows) {
    const std::span<const Vec3> x = particles.x;
    cells_ = grid.size();
    cell_.reserve(particles.id.capacity());
    for (auto& spare : spare_) spare.reserve(particles.id.capacity());
    cell_.resize(x.size());
    order_.reserve(particles.id.capacity());
    order_.resize(x.size());
    start_.resize(cells_ + 1);

    // Each slice counts all cells, so there are as many as threads; a stable sort has one result,
    // however it is cut.
    const auto most = static_cast<std::size_t>(parallel::threads());
    slice_length_ = std::max(SMALLEST_SLICE, (x.size() + most - 1) / most);
    const std::size_t slices = parallel::chunk_count(x.size(), slice_length_);
    fill_.resize(slices * cells_);

    std::vector<Index> sums(parallel::chunk_count(cells_, SORTED_CELLS_A_CHUNK));
    parallel::in_turn(parallel::each(
                          slices, [&](std::size_t s) { count(grid, x, s); }, 1),
                      parallel::each(
                          sums.size(), [&](std::size_t c) { sums[c] = sum(c, slices); }, 1),
                      parallel::each(
                          sums.size(), [&](std::size_t c) { share_out(c, sums, slices); }, 1),
                      parallel::each(
                          slices, [&](std::size_t s) { place(s); }, 1));
    if (moves_rows) move_rows(particles);
}

/// Particles in a chunk of cells, from the slices' counts.
Index CellSort::sum(std::size_t chunk, std::size_t slices) const {
    const std::size_t begin = chunk * SORTED_CELLS_A_CHUNK,
                      end = std::min(cells_, begin + SORTED_CELLS_A_CHUNK);
    Index all = 0;
    for (std::size_t s = 0; s < slices; ++s)
        for (std::size_t c = begin; c < end; ++c) all += fill_[s * cells_ + c];
    return all;
}

/// Where each cell of a chunk begins, and each slice's part of it.
void CellSort::share_out(std::size_t chunk, std::span<const Index> sums, std::size_t slices) {
    const std::size_t begin = chunk * SORTED_CELLS_A_CHUNK,
                      end = std::min(cells_, begin + SORTED_CELLS_A_CHUNK);
    const auto before = sums.first(chunk);
    Index next = std::accumulate(before.begin(), before.end(), Index{0});
    for (std::size_t c = begin; c < end; ++c) {
        start_[c] = next;
        for (std::size_t s = 0; s < slices; ++s) next += std::exchange(fill_[s * cells_ + c], next);
    }
    if (end == cells_) start_[cells_] = next;
}

void CellSort::count(const Grid& grid, std::span<const Vec3> x, std::size_t slice) {
    Index* const counts = fill_.data() + slice * cells_;
    std::fill(counts, counts + cells_, 0);
    const std::size_t begin = slice * slice_length_;
    const std::size_t end = std::min(x.size(), begin + slice_length_);
    find_cells(grid, x.subspan(begin, end - begin), cell_.data() + begin);
    for (std::size_t i = begin; i < end; ++i) ++counts[cell_[i]];
}

void CellSort::place(std::size_t slice) {
    Index* const next = fill_.data() + slice * cells_;
    const std::size_t end = std::min(cell_.size(), (slice + 1) * slice_length_);
    for (std::size_t i = slice * slice_length_; i < end; ++i)
        order_[static_cast<std::size_t>(next[cell_[i]]++)] = static_cast<Index>(i);
}

/// Places and velocities change places with what they are gathered into; the rest is gathered where
/// places were, and written back.
void CellSort::move_rows(Particles& particles) {
    const std::size_t n = order_.size();
    if (n == 0) return;
    for (auto& spare : spare_) spare.resize(n);
    std::vector<Column> rest{Column::of(particles.e), Column::of(particles.species),
                             Column::of(particles.id), Column::of(particles.safe_distance)};
    if (!particles.room.empty()) rest.push_back(Column::of(particles.room));
    for (std::size_t k = 1; k < rest.size(); ++k)
        rest[k].ahead_of = rest[k - 1].ahead_of + rest[k - 1].size;
    const Column x = Column::of(particles.x), v = Column::of(particles.v);
    const auto move = [&](std::size_t stage) {
        const auto chunk = [&, stage](std::size_t begin, std::size_t end, std::size_t) {
            if (stage == 0) return x.gather(begin, end, order_, spare_[0]);
            if (stage == 1) {
                v.gather(begin, end, order_, spare_[1]);
                for (const Column& column : rest) column.gather(begin, end, order_, particles.x);
                return;
            }
            for (const Column& column : rest) column.write(begin, end, particles.x);
            std::iota(order_.begin() + static_cast<std::ptrdiff_t>(begin),
                      order_.begin() + static_cast<std::ptrdiff_t>(end), static_cast<Index>(begin));
        };
        return parallel::Loop<decltype(chunk)>{n, chunk, parallel::Cut()};
    };
    parallel::in_turn(3, move);
    particles.x.swap(spare_[0]);
    particles.v.swap(spare_[1]);
}

}  // namespace corpuscle::gas
