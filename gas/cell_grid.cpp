// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/cell_grid.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "gas/lanes.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

namespace {

constexpr std::size_t SMALLEST_SLICE = 8192;  ///< particles worth a thread

/// Grid::cell_of() of many points, by fours.
void find_cells(const Grid& grid, std::span<const Vec3> x, Index* cell) {
    using lanes::Four;
    const std::size_t fours = x.size() / lanes::LANES;
    for (std::size_t q = 0; q < fours; ++q) {
        const double* const at = x[q * lanes::LANES].data();
        const auto column = lanes::columns(lanes::load(at), lanes::load(at + lanes::LANES),
                                           lanes::load(at + 2 * lanes::LANES));
        using Ints = std::int32_t __attribute__((vector_size(16)));
        std::array<Ints, 3> along;
        for (int a = 0; a < 3; ++a) {
            const Four cells = (column[a] - grid.low[a]) * grid.per_edge,
                       last = lanes::all(grid.count[a] - 1.0);
            const Four least = cells < 0.0 ? lanes::all(0.0) : cells;
            along[a] = __builtin_convertvector(least > last ? last : least, Ints);
        }
        const Ints row = (along[2] * grid.count[1] + along[1]) * grid.count[0] + along[0];
        std::memcpy(cell + q * lanes::LANES, &row, sizeof(row));
    }
    for (std::size_t i = fours * lanes::LANES; i < x.size(); ++i)
        cell[i] = static_cast<Index>(grid.cell_of(x[i]));
}

}  // namespace

void CellSort::sort(const Grid& grid, Particles& particles, bool moves_rows) {
    const std::span<const Vec3> x = particles.x;
    cells_ = grid.size();
    // They change places with the particles' columns, so they must hold as many.
    cell_.reserve(particles.id.capacity());
    spare_.reserve(particles.x.capacity());
    cell_.resize(x.size());
    order_.reserve(particles.id.capacity());
    order_.resize(x.size());
    start_.resize(cells_ + 1);

    // One slice of the particles a thread. A stable sort has one result, however it is cut.
    const auto threads = static_cast<std::size_t>(parallel::threads());
    slice_length_ = std::max(SMALLEST_SLICE, (x.size() + threads - 1) / threads);
    const std::size_t slices = parallel::chunk_count(x.size(), slice_length_);
    fill_.assign(slices * cells_, 0);

    parallel::for_each(
        slices, [&](std::size_t s) { count(grid, x, s); }, 1);
    Index next = 0;
    for (std::size_t c = 0; c < cells_; ++c) {
        start_[c] = next;
        for (std::size_t s = 0; s < slices; ++s) next += std::exchange(fill_[s * cells_ + c], next);
    }
    start_[cells_] = next;
    parallel::for_each(
        slices, [&](std::size_t s) { place(s); }, 1);
    if (moves_rows) move_rows(particles);
}

void CellSort::count(const Grid& grid, std::span<const Vec3> x, std::size_t slice) {
    Index* const counts = fill_.data() + slice * cells_;
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

/// Column by column, so that one spare column does for all.
void CellSort::move_rows(Particles& particles) {
    const std::size_t n = order_.size();
    const auto pick = [&](const auto* from, auto* to) {
        parallel::for_each(n, [&](std::size_t i) { to[i] = from[order_[i]]; });
    };
    spare_.resize(n);
    for (auto* column : {&particles.x, &particles.v}) {
        pick(column->data(), spare_.data());
        std::swap(*column, spare_);
    }
    for (auto* column : {&particles.species, &particles.id}) {
        pick(column->data(), cell_.data());
        std::swap(*column, cell_);
    }
    auto* const spare_floats = reinterpret_cast<float*>(cell_.data());
    pick(particles.clear.data(), spare_floats);
    std::copy(spare_floats, spare_floats + n, particles.clear.begin());
    double* const spare = n > 0 ? spare_[0].data() : nullptr;
    pick(particles.e.data(), spare);
    std::copy(spare, spare + n, particles.e.begin());
    parallel::for_each(n, [&](std::size_t i) { order_[i] = static_cast<Index>(i); });
}

}  // namespace corpuscle::gas
