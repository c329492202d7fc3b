// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/wall_monitor.hpp"

#include <algorithm>
#include <utility>

#include "solver/base/parallel.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {
namespace {

constexpr std::size_t HIT_PATCHES_A_CHUNK = 8;

}  // namespace

WallMonitor::WallMonitor(std::shared_ptr<const WettedSurface> surface, const BagWalls& walls,
                         bool is_rough)
    : surface_(std::move(surface)),
      is_rough_(is_rough),
      part_(walls.part),
      impulse_(surface_->sides(), 0.0),
      part_impulse_(walls.part_ids.size(), 0.0),
      triangle_impulse_(walls.triangles.size(), 0.0),
      part_air_(surface_->rooms(), 0.0),
      triangle_air_(part_air_) {}

void WallMonitor::record(const WallHits& hits, std::span<const Vec3> x_1) {
    const auto take = [&](std::size_t patch) {
        for (const auto& [hit, side, settles] : hits.of(patch)) {
            const auto& [a, b, c] = surface_->triangles()[hit->facet];
            impulse_[side] +=
                surface_->closes(static_cast<std::size_t>(hit->facet)) && !is_rough_
                    ? hit->impulse.norm()
                    : hit->impulse.dot(vector_area(x_1[a], x_1[b], x_1[c]).normalized());
        }
    };
    parallel::for_each(hits.patches().size(), take, HIT_PATCHES_A_CHUNK);
}

/// Hands impulses on to parts and triangles.
void WallMonitor::share_out() {
    for (std::size_t side = 0; side < impulse_.size(); ++side) {
        const double impulse = std::exchange(impulse_[side], 0.0);
        const Index facet = surface_->facet(side);
        part_impulse_[part_[facet]] += impulse;
        triangle_impulse_[facet] += impulse;
    }
}

void WallMonitor::record(std::span<const double> room_pressure, double t) {
    const double span = t - std::exchange(until_, t);
    for (std::size_t r = 0; r < part_air_.size(); ++r) {
        part_air_[r] += room_pressure[r] * span;
        triangle_air_[r] += room_pressure[r] * span;
    }
}

/// Pressure that no particles bring, on a facet's inside; and that across an internal one.
double WallMonitor::across(std::size_t facet, std::span<const double> of_room) const {
    const double push = of_room[surface_->room(surface_->side(facet, false))];
    if (surface_->closes(facet)) return push;
    return push - of_room[surface_->room(surface_->side(facet, true))];
}

void WallMonitor::part_means(const BagWalls& walls, std::span<const Vec3> x, double since,
                             std::span<const double> room_pressure, PartState& parts) {
    share_out();
    parts.pressure.assign(part_impulse_.size(), 0.0);
    parts.area.assign(part_impulse_.size(), 0.0);
    if (since == 0.0) std::copy(room_pressure.begin(), room_pressure.end(), part_air_.begin());
    const double time = since > 0.0 ? since : 1.0;
    std::vector<double> air(part_impulse_.size(), 0.0);
    for (std::size_t t = 0; t < walls.triangles.size(); ++t) {
        const auto& [a, b, c] = walls.triangles[t];
        const double size = vector_area(x[a], x[b], x[c]).norm();
        parts.area[part_[t]] += size;
        air[part_[t]] += size * across(t, part_air_) / time;
    }
    for (std::size_t p = 0; p < parts.area.size(); ++p) {
        const double particles = since > 0.0 ? part_impulse_[p] / since : 0.0;
        parts.pressure[p] = parts.area[p] > 0.0 ? (air[p] + particles) / parts.area[p] : 0.0;
        part_impulse_[p] = 0.0;
    }
    std::fill(part_air_.begin(), part_air_.end(), 0.0);
}

void WallMonitor::add_shell_means(const BagWalls& walls, double p_atm, std::span<const Vec3> x,
                                  double since, std::span<const double> room_pressure,
                                  ShellLoad& load) {
    share_out();
    if (since == 0.0) std::copy(room_pressure.begin(), room_pressure.end(), triangle_air_.begin());
    const double time = since > 0.0 ? since : 1.0;
    for (std::size_t t = 0; t < walls.triangles.size(); ++t) {
        const auto& [a, b, c] = walls.triangles[t];
        const double size = vector_area(x[a], x[b], x[c]).norm();
        const Index shell = walls.shell[t];
        const double sign = load.sign(shell, surface_->triangles()[t] != walls.triangles[t]);
        double& force = load.force[shell];
        force += sign * across(t, triangle_air_) / time * size;
        if (t < walls.closing) force -= sign * p_atm * size;
        if (since > 0.0) force += sign * triangle_impulse_[t] / since;
        triangle_impulse_[t] = 0.0;
    }
    std::fill(triangle_air_.begin(), triangle_air_.end(), 0.0);
}

}  // namespace corpuscle::gas
