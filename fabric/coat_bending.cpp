// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "fabric/coat_bending.hpp"

#include <algorithm>
#include <cmath>

#include "fabric/coat_patch.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::fabric {
namespace {

constexpr std::size_t CHUNK = 128;  // rows or nodes

/// B of two coats beside cloth of thickness h. [N·m]
double bending_stiffness(const FabricCard& card, double h) {
    const double inner = 0.5 * h, outer = inner + card.coat_thickness;
    return 2.0 / 3.0 * card.coat_E * (outer * outer * outer - inner * inner * inner);
}

}  // namespace

CoatBending::CoatBending(const MembraneSetup& setup, const std::vector<double>& mass) {
    for (std::size_t p = 0; p < setup.parts.size(); ++p) {
        const Part& part = setup.parts[p];
        const auto* card =
            std::get_if<FabricCard>(&setup.materials[static_cast<std::size_t>(part.material)].card);
        if (card != nullptr && card->has_coat())
            add_part(setup, static_cast<Index>(p), bending_stiffness(*card, part.thickness));
    }
    bend_.assign(rows_.size(), Vec3::Zero());
    gather(setup.node_count);
    find_rate(mass);
}

void CoatBending::add_part(const MembraneSetup& setup, Index part, double stiffness) {
    const CoatPatch patch(setup, part);
    for (const CoatPatch::Node& node : patch.nodes()) {
        if (!node.bends) continue;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto begin = static_cast<std::uint32_t>(entries_.size());
            for (const CoatPatch::Neighbour& m : node.neighbours)
                entries_.push_back({m.row, m.weight[k]});
            rows_.push_back({node.row, begin, static_cast<std::uint32_t>(entries_.size()),
                             stiffness * node.reckoned_area * (k == 2 ? 2.0 : 1.0)});
        }
    }
    if (patch.nodes().empty()) return;
    part_end_.emplace_back(part, rows_.size());
    parts_.push_back({part, patch.inner_count(), patch.sewn_count()});
}

/// Counting sort of all entries by the node that they pull.
void CoatBending::gather(std::size_t node_count) {
    if (empty()) return;
    std::vector<std::vector<Pull>> of(node_count);
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        double sum = 0.0;
        for (std::uint32_t k = rows_[r].begin; k < rows_[r].end; ++k) {
            const double weight = rows_[r].factor * entries_[k].weight;
            of[static_cast<std::size_t>(entries_[k].node)].push_back(
                {static_cast<std::uint32_t>(r), weight});
            sum += weight;
        }
        of[static_cast<std::size_t>(rows_[r].node)].push_back(
            {static_cast<std::uint32_t>(r), -sum});
    }
    for (std::size_t n = 0; n < node_count; ++n) {
        if (of[n].empty()) continue;
        nodes_.push_back(static_cast<Index>(n));
        starts_.push_back(static_cast<std::uint32_t>(pulls_.size()));
        pulls_.insert(pulls_.end(), of[n].begin(), of[n].end());
    }
    starts_.push_back(static_cast<std::uint32_t>(pulls_.size()));
}

/// Row sums of |M^(-½) Q M^(-½)|, Q_nm = Σ_r c_r w_rn w_rm.
void CoatBending::find_rate(const std::vector<double>& mass) {
    const auto root = [&](Index n) { return std::sqrt(mass[static_cast<std::size_t>(n)]); };
    std::vector<double> spread;  // of every row: Σ_m |w_rm| / √m_m
    for (const Row& row : rows_) {
        double sum = 0.0, own = 0.0;
        for (std::uint32_t k = row.begin; k < row.end; ++k) {
            sum += std::abs(entries_[k].weight) / root(entries_[k].node);
            own += entries_[k].weight;
        }
        spread.push_back(sum + std::abs(own) / root(row.node));
    }
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        double sum = 0.0;
        for (std::uint32_t k = starts_[i]; k < starts_[i + 1]; ++k)
            sum += std::abs(pulls_[k].weight) * spread[pulls_[k].row];
        rate_ = std::max(rate_, sum / root(nodes_[i]));
    }
}

double CoatBending::lengthened(double dt) const {
    const double rest = 1.0 - rate_ * dt * dt;
    return rest > 0.0 ? 2.0 * dt / (1.0 + std::sqrt(rest)) : INF;
}

void CoatBending::add_force(const Points& x, Points& f) {
    const auto at = [&](Index n) -> const Vec3& { return x[static_cast<std::size_t>(n)]; };
    parallel::for_each(
        rows_.size(),
        [&](std::size_t r) {
            Vec3 sum = Vec3::Zero();
            for (std::uint32_t k = rows_[r].begin; k < rows_[r].end; ++k)
                sum += entries_[k].weight * (at(entries_[k].node) - at(rows_[r].node));
            bend_[r] = sum;
        },
        CHUNK);
    parallel::for_each(
        nodes_.size(),
        [&](std::size_t i) {
            Vec3 sum = Vec3::Zero();
            for (std::uint32_t k = starts_[i]; k < starts_[i + 1]; ++k)
                sum += pulls_[k].weight * bend_[pulls_[k].row];
            f[static_cast<std::size_t>(nodes_[i])] -= sum;
        },
        CHUNK);
}

void CoatBending::add_energy(std::vector<double>& part_energy) const {
    std::size_t begin = 0;
    for (const auto& [part, end] : part_end_) {
        part_energy[static_cast<std::size_t>(part)] +=
            parallel::sum(end - begin, 0.0, [&, first = begin](std::size_t i) {
                return 0.5 * rows_[first + i].factor * bend_[first + i].squaredNorm();
            });
        begin = end;
    }
}

}  // namespace corpuscle::fabric
