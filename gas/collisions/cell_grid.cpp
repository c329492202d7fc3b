// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/collisions/cell_grid.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "solver/base/parallel.hpp"
#include "solver/base/simd.hpp"

namespace corpuscle::gas {

namespace {

constexpr std::size_t SMALLEST_SLICE = 512;  ///< particles worth a thread
constexpr std::size_t MOST_SLICES = 16;      ///< each counts all cells
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

void CellSort::sort(const Grid& grid, Particles& particles, bool moves_rows) {
    const std::span<const Vec3> x = particles.x;
    cells_ = grid.size();
    cell_.reserve(particles.id.capacity());
    spare_.reserve(particles.id.capacity());
    cell_.resize(x.size());
    order_.reserve(particles.id.capacity());
    order_.resize(x.size());
    start_.resize(cells_ + 1);

    // A stable sort has one result, however it is cut.
    slice_length_ = std::max(SMALLEST_SLICE, (x.size() + MOST_SLICES - 1) / MOST_SLICES);
    const std::size_t slices = parallel::chunk_count(x.size(), slice_length_);
    fill_.resize(slices * cells_);

    parallel::for_each(
        slices, [&](std::size_t s) { count(grid, x, s); }, 1);
    find_starts(slices);
    parallel::for_each(
        slices, [&](std::size_t s) { place(s); }, 1);
    if (moves_rows) move_rows(particles);
}

/// From the slices' counts: where each cell begins, and each slice's part of it.
void CellSort::find_starts(std::size_t slices) {
    std::vector<Index> before(parallel::chunk_count(cells_, SORTED_CELLS_A_CHUNK) + 1, 0);
    const auto sum = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Index all = 0;
        for (std::size_t s = 0; s < slices; ++s)
            for (std::size_t c = begin; c < end; ++c) all += fill_[s * cells_ + c];
        before[chunk + 1] = all;
    };
    const auto share_out = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        Index next = before[chunk];
        for (std::size_t c = begin; c < end; ++c) {
            start_[c] = next;
            for (std::size_t s = 0; s < slices; ++s)
                next += std::exchange(fill_[s * cells_ + c], next);
        }
    };
    parallel::for_chunks(cells_, sum, SORTED_CELLS_A_CHUNK);
    for (std::size_t k = 1; k < before.size(); ++k) before[k] += before[k - 1];
    parallel::for_chunks(cells_, share_out, SORTED_CELLS_A_CHUNK);
    start_[cells_] = before.back();
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

/// Number by number, so that eight spare bytes a particle do for all.
void CellSort::move_rows(Particles& particles) {
    const std::size_t n = order_.size();
    spare_.resize(n);
    const auto move = [&]<class T>(T* numbers, std::size_t stride) {
        T* const spare = reinterpret_cast<T*>(spare_.data());
        parallel::for_each(n, [&](std::size_t i) {
            spare[i] = numbers[stride * static_cast<std::size_t>(order_[i])];
        });
        parallel::for_each(n, [&](std::size_t i) { numbers[stride * i] = spare[i]; });
    };
    if (n == 0) return;
    for (auto* column : {&particles.x, &particles.v})
        for (int a = 0; a < 3; ++a) move((*column)[0].data() + a, 3);
    move(particles.e.data(), 1);
    for (auto* column : {&particles.species, &particles.id}) move(column->data(), 1);
    move(particles.safe_distance.data(), 1);
    if (!particles.room.empty()) move(particles.room.data(), 1);
    parallel::for_each(n, [&](std::size_t i) { order_[i] = static_cast<Index>(i); });
}

}  // namespace corpuscle::gas
