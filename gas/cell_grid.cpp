// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/cell_grid.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

namespace {

constexpr std::size_t SMALLEST_SLICE = 8192;  ///< particles worth a thread

}  // namespace

void CellSort::sort(const Grid& grid, Particles& particles) {
    const std::span<const Vec3> x = particles.x;
    cells_ = grid.size();
    cell_.resize(x.size());
    sorted_.resize(x.size());
    start_.resize(cells_ + 1);
    while (row_.size() < x.size()) row_.push_back(static_cast<Index>(row_.size()));

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
        slices, [&](std::size_t s) { place(particles, s); }, 1);
    std::swap(particles, sorted_);
}

void CellSort::count(const Grid& grid, std::span<const Vec3> x, std::size_t slice) {
    Index* const counts = fill_.data() + slice * cells_;
    const std::size_t end = std::min(x.size(), (slice + 1) * slice_length_);
    for (std::size_t i = slice * slice_length_; i < end; ++i) {
        const std::size_t cell = grid.cell_of(x[i]);
        cell_[i] = static_cast<Index>(cell);
        ++counts[cell];
    }
}

void CellSort::place(const Particles& from, std::size_t slice) {
    Index* const next = fill_.data() + slice * cells_;
    const std::size_t end = std::min(from.size(), (slice + 1) * slice_length_);
    for (std::size_t i = slice * slice_length_; i < end; ++i) {
        const auto to = static_cast<std::size_t>(next[cell_[i]]++);
        sorted_.x[to] = from.x[i];
        sorted_.v[to] = from.v[i];
        sorted_.e[to] = from.e[i];
        sorted_.species[to] = from.species[i];
        sorted_.id[to] = from.id[i];
    }
}

}  // namespace corpuscle::gas
