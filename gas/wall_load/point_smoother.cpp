// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/point_smoother.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// More: quieter, but the load's image of a front is blurred by more cloth (some 0.65 sqrt(PASSES)
/// edges, one standard deviation).
constexpr int PASSES = 9;

/// Cosines of the angle between two points' normals at which a gate begins to open, and is open.
constexpr double SHUT = 0.6, OPEN = 0.85;

}  // namespace

PointSmoother::PointSmoother(const WettedSurface& surface)
    : link_(surface.edges().size(), 0.0),
      per_area_(surface.points(), 0.0),
      next_(surface.points()) {
    share_.reserve(surface.edges().size());
    for (const auto& [a, b] : surface.edges())
        share_.push_back(1.0 / (1.0 + static_cast<double>(std::max(surface.neighbours(a).size(),
                                                                   surface.neighbours(b).size()))));
}

void PointSmoother::prepare(const WettedSurface& surface, std::span<const Vec3> area,
                            std::span<const double> size,
                            std::span<const std::uint8_t> takes_part) {
    const auto& edges = surface.edges();
    parallel::for_each(edges.size(), [&](std::size_t e) {
        const auto [a, b] = edges[e];
        link_[e] = 0.0;
        if (takes_part[a] == 0 || takes_part[b] == 0) return;
        const double cosine = area[a].dot(area[b]) / (size[a] * size[b]);
        const double gate = std::clamp((cosine - SHUT) / (OPEN - SHUT), 0.0, 1.0);
        link_[e] = share_[e] * gate * std::min(size[a], size[b]);
    });
    parallel::for_each(surface.points(),
                       [&](std::size_t p) { per_area_[p] = size[p] > 0.0 ? 1.0 / size[p] : 0.0; });
}

void PointSmoother::spread(const WettedSurface& surface, std::vector<Brought>& field) {
    for (int pass = 0; pass < PASSES; ++pass) {
        parallel::for_each(surface.points(), [&](std::size_t p) {
            const Brought own = field[p];
            Brought gain;
            for (const auto& [q, edge] : surface.neighbours(p)) {
                gain.push += link_[edge] * (field[q].push - own.push);
                gain.mass += link_[edge] * (field[q].mass - own.mass);
                gain.speed += link_[edge] * (field[q].speed - own.speed);
                gain.beside += link_[edge] * (field[q].beside - own.beside);
            }
            next_[p] = {own.push + per_area_[p] * gain.push, own.mass + per_area_[p] * gain.mass,
                        own.speed + per_area_[p] * gain.speed,
                        own.beside + per_area_[p] * gain.beside};
        });
        field.swap(next_);
    }
}

}  // namespace corpuscle::gas
