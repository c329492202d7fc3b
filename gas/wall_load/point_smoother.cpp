// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/point_smoother.hpp"

#include <algorithm>

#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// More: quieter, but the load's image of a front is blurred by more cloth (some 0.65 sqrt(PASSES)
/// edges, one standard deviation).
constexpr std::size_t PASSES = 9;

constexpr std::size_t FEW_POINTS = 128;  ///< that one thread is done with sooner
constexpr std::size_t POINTS_A_CHUNK = 16;

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
    const auto set_link = [&](std::size_t e) {
        const auto [a, b] = edges[e];
        link_[e] = 0.0;
        if (takes_part[a] == 0 || takes_part[b] == 0) return;
        const double cosine = area[a].dot(area[b]) / (size[a] * size[b]);
        const double gate = std::clamp((cosine - SHUT) / (OPEN - SHUT), 0.0, 1.0);
        link_[e] = share_[e] * gate * std::min(size[a], size[b]);
    };
    parallel::side_by_side(parallel::each(edges.size(), set_link),
                           parallel::each(surface.points(), [&](std::size_t p) {
                               per_area_[p] = size[p] > 0.0 ? 1.0 / size[p] : 0.0;
                           }));
}

void PointSmoother::spread(const WettedSurface& surface, std::vector<Brought>& field) {
    const parallel::Cut cut =
        surface.points() > FEW_POINTS ? parallel::Cut(POINTS_A_CHUNK) : parallel::Cut();
    Brought *const here = field.data(), *const there = next_.data();
    const auto spread_once = [&](std::size_t pass) {
        const Brought* const from = pass % 2 == 0 ? here : there;
        Brought* const to = pass % 2 == 0 ? there : here;
        return parallel::each(
            surface.points(),
            [this, &surface, from, to](std::size_t p) {
                const Brought own = from[p];
                Brought gain;
                for (const auto& [q, edge] : surface.neighbours(p)) {
                    gain.push += link_[edge] * (from[q].push - own.push);
                    gain.mass += link_[edge] * (from[q].mass - own.mass);
                    gain.beside += link_[edge] * (from[q].beside - own.beside);
                }
                to[p] = {own.push + per_area_[p] * gain.push, own.mass + per_area_[p] * gain.mass,
                         own.beside + per_area_[p] * gain.beside};
            },
            cut);
    };
    parallel::in_turn(PASSES, spread_once);
    if (PASSES % 2 == 1) field.swap(next_);
}

double PointSmoother::unevenness(const WettedSurface& surface, std::size_t p,
                                 std::span<const double> impulse) const {
    const double own = impulse[p] * per_area_[p];
    double sum = 0.0;
    for (const auto& [q, edge] : surface.neighbours(p)) {
        const double step = impulse[q] * per_area_[q] - own;
        sum += link_[edge] * step * step;
    }
    return sum;
}

void PointSmoother::spread(const WettedSurface& surface, PlaceSpread& impulse) const {
    thread_local std::vector<double> kept;
    std::vector<double>& per_area = kept;  // before a pass
    for (std::size_t pass = 0; pass < PASSES; ++pass) {
        per_area.clear();
        for (const Index p : impulse.points()) per_area.push_back(per_area_[p] * impulse.share(p));
        for (std::size_t i = 0; i < per_area.size(); ++i) {
            const Index p = impulse.points()[i];
            for (const auto& [q, edge] : surface.neighbours(p)) {
                if (link_[edge] == 0.0) continue;
                const double passed = link_[edge] * per_area[i];
                impulse.add(q, passed);
                impulse.add(p, -passed);
            }
        }
    }
}

}  // namespace corpuscle::gas
