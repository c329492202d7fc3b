// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/cell_grid.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

namespace {

constexpr std::size_t SMALLEST_SLICE = 8192;  ///< particles worth a thread

template <class T>
void gather(std::span<const Index> order, const std::vector<T>& from, std::vector<T>& to) {
    to.resize(from.size());
    parallel::for_each(order.size(), [&](std::size_t i) { to[i] = from[order[i]]; });
}

}  // namespace

void CellSort::sort(const Grid& grid, std::span<const Vec3> x) {
    cells_ = grid.size();
    cell_.resize(x.size());
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

void CellSort::place(std::size_t slice) {
    Index* const next = fill_.data() + slice * cells_;
    const std::size_t end = std::min(order_.size(), (slice + 1) * slice_length_);
    for (std::size_t i = slice * slice_length_; i < end; ++i)
        order_[next[cell_[i]]++] = static_cast<Index>(i);
}

void reorder(std::span<const Index> order, Particles& particles, Particles& scratch) {
    assert(order.size() == particles.size());
    gather(order, particles.x, scratch.x);
    gather(order, particles.v, scratch.v);
    gather(order, particles.e, scratch.e);
    gather(order, particles.species, scratch.species);
    gather(order, particles.id, scratch.id);
    std::swap(particles, scratch);
}

}  // namespace corpuscle::gas
