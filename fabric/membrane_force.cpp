// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cassert>
#include <cmath>

#include "fabric/membrane_block.hpp"
#include "fabric/membranes.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::fabric {

namespace {

constexpr std::size_t GATHER_NODES = 64;  // a chunk

Vec3 gathered(const std::vector<std::uint32_t>& places, std::uint32_t begin, std::uint32_t end,
              const double* corner) {
    double x = 0.0, y = 0.0, z = 0.0;
    for (std::uint32_t k = begin; k < end; ++k) {
        const double* at = corner + places[k];
        x += at[0];
        y += at[LANES];
        z += at[2 * LANES];
    }
    return {x, y, z};
}

}  // namespace

std::size_t Membranes::chunks_of(const Gather& gather) {
    return parallel::chunk_count(gather.nodes.size(), GATHER_NODES);
}

Index Membranes::add_force(const Points& x, const Points& v, Points& f) {
    assert(x.size() == f.size() && v.size() == f.size());
    // 1. Every element writes the forces of its corners
    const auto work = [&](std::size_t i) {
        const Task& task = tasks_[i];
        const MembraneBlock::Result r = blocks_[task.block]->force(
            task.begin, task.end, x, v, corner_force_.data() + block_start_[task.block],
            corner_damping_.data() + damped_start_[task.block]);
        found_[i] = {r.energy, r.rate, r.shell, r.lost, r.pull};
    };
    // 2. Every node gathers them, then those that damp
    const auto gather = [&](std::size_t chunk) { gather_forces(chunk, f); };
    const auto damp = [&](std::size_t chunk) { gather_damping(chunk, f); };
    parallel::in_turn(parallel::each(tasks_.size(), work, 1),
                      parallel::each(chunks_of(gather_), gather, 1),
                      parallel::each(chunks_of(damping_gather_), damp, 1));
    coat_.add_force(x, f);
    reduce();
    return all_finite() ? -1 : first_broken(x);
}

void Membranes::gather_forces(std::size_t chunk, Points& f) {
    const std::size_t end = std::min(gather_.nodes.size(), (chunk + 1) * GATHER_NODES);
    Vec3 total = Vec3::Zero();
    for (std::size_t i = chunk * GATHER_NODES; i < end; ++i) {
        const Vec3 sum = gathered(gather_.places, gather_.starts[i], gather_.starts[i + 1],
                                  corner_force_.data());
        f[static_cast<std::size_t>(gather_.nodes[i])] += sum;
        total += sum;
    }
    gather_check_[chunk] = total.sum();
}

void Membranes::gather_damping(std::size_t chunk, Points& f) {
    const Gather& from = damping_gather_;
    const std::size_t end = std::min(from.nodes.size(), (chunk + 1) * GATHER_NODES);
    double total = 0.0;
    for (std::size_t i = chunk * GATHER_NODES; i < end; ++i) {
        const auto node = static_cast<std::size_t>(from.nodes[i]);
        damping_force_[node] =
            gathered(from.places, from.starts[i], from.starts[i + 1], corner_damping_.data());
        f[node] += damping_force_[node];
        total += damping_force_[node].sum();
    }
    damping_check_[chunk] = total;
}

/// What the tasks found, in their order.
void Membranes::reduce() {
    std::fill(part_energy_.begin(), part_energy_.end(), 0.0);
    auto [rate, shell] = rest_;
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
        part_energy_[static_cast<std::size_t>(blocks_[tasks_[i].block]->part)] += found_[i].energy;
        lost_energy_ += found_[i].lost;
        if (found_[i].rate > rate) {
            rate = found_[i].rate;
            shell = found_[i].shell;
        }
    }
    coat_.add_energy(part_energy_);
    if (rate > 0.0) step_.take(coat_.shortened(2.0 / std::sqrt(rate)), shell);
    book_restored();
}

double Membranes::strain_energy() const {
    double total = 0.0;
    for (const double energy : part_energy_) total += energy;
    return total;
}

double Membranes::damping_energy(const Points& v_0, const Points& v_1, double dt) const {
    const std::vector<Index>& nodes = damping_gather_.nodes;
    return parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
        const auto n = static_cast<std::size_t>(nodes[i]);
        return -0.5 * dt * damping_force_[n].dot(v_0[n] + v_1[n]);
    });
}

bool Membranes::all_finite() const {
    double sum = strain_energy();
    for (const double check : gather_check_) sum += check;
    for (const double check : damping_check_) sum += check;
    return std::isfinite(sum);
}

Index Membranes::first_broken(const Points& x) const {
    Index first = -1;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
        const Index broken = blocks_[b]->first_broken(x, corner_force_.data() + block_start_[b],
                                                      corner_damping_.data() + damped_start_[b]);
        if (broken >= 0 && (first < 0 || broken < first)) first = broken;
    }
    return first;
}

void Membranes::stress_strain(const Points& x, std::span<std::array<float, 3>> stress,
                              std::span<std::array<float, 3>> strain) const {
    std::fill(stress.begin(), stress.end(), std::array<float, 3>{});
    std::fill(strain.begin(), strain.end(), std::array<float, 3>{});
    for (const auto& block : blocks_) block->stress_strain(x, stress, strain);
}

}  // namespace corpuscle::fabric
