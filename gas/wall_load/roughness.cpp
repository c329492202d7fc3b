// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/roughness.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace corpuscle::gas {
namespace {

/// The card that counts for a part: one that names it, else the one for all; nullptr: none.
const FrictionCard* card_for(const std::vector<FrictionCard>& cards, Index part) {
    const FrictionCard* found = nullptr;
    for (const FrictionCard& card : cards) {
        if (std::find(card.parts.begin(), card.parts.end(), part) != card.parts.end()) return &card;
        if (card.parts.empty()) found = &card;
    }
    return found;
}

}  // namespace

Roughness::Roughness(const BagCard& card, const BagWalls& walls,
                     std::shared_ptr<const WettedSurface> surface, std::span<const Curve> curves,
                     double time)
    : surface_(std::move(surface)),
      pushes_along_(card.friction_pushes_along),
      closing_(static_cast<Index>(walls.closing)),
      time_(time) {
    if (card.friction.empty()) return;
    rough_of_.assign(surface_->sides(), -1);
    for (std::size_t s = 0; s < surface_->sides(); ++s) {
        const Index part = walls.part[surface_->facet(s)];
        const FrictionCard* friction = card_for(card.friction, walls.part_rows[part]);
        of_side_.push_back(friction == nullptr ? 0.0 : friction->factor);
        if (friction == nullptr || friction->curve < 0) continue;
        const Curve& over_pressure = curves[friction->curve];
        of_side_[s] = over_pressure(0.0);
        rough_of_[s] = row_of(part, surface_->room(s), over_pressure);
    }
}

/// Row of a part in a room, a new one where there is none.
Index Roughness::row_of(Index part, Index room, const Curve& over_pressure) {
    const auto found = std::find_if(rough_.begin(), rough_.end(), [&](const Rough& rough) {
        return rough.part == part && rough.room == room;
    });
    const auto row = static_cast<Index>(found - rough_.begin());
    if (found == rough_.end()) rough_.push_back({part, room, over_pressure});
    return row;
}

void Roughness::receive(const FlightResult& flight, const WallHits& hits, double dt,
                        std::span<const double> air, std::span<const Vec3> x) {
    if (rough_.empty()) return;
    for (Rough& part : rough_) part.impulse = part.area = 0.0;
    const std::vector<Triangle>& triangles = surface_->triangles();
    for (std::size_t l = 0; l < flight.hits.size(); ++l)
        for (std::size_t k = 0; k < flight.hits[l].size(); ++k)
            if (const Index r = rough_of_[hits.sides(l)[k]]; r >= 0) {
                const Hit& hit = flight.hits[l][k];
                const auto& [a, b, c] = triangles[hit.facet];
                rough_[r].impulse +=
                    std::abs(hit.impulse.dot(vector_area(x[a], x[b], x[c]).normalized()));
            }
    for (std::size_t s = 0; s < rough_of_.size(); ++s)
        if (const Index r = rough_of_[s]; r >= 0) {
            const auto& [a, b, c] = triangles[surface_->facet(s)];
            rough_[r].area += vector_area(x[a], x[b], x[c]).norm();
        }
    const double fresh = -std::expm1(-dt / time_);
    for (Rough& part : rough_) {
        if (part.area > 0.0)
            part.pressure += fresh * (part.impulse / (dt * part.area) - part.pressure);
    }
    for (std::size_t s = 0; s < rough_of_.size(); ++s)
        if (const Index r = rough_of_[s]; r >= 0)
            of_side_[s] = rough_[r].over_pressure(rough_[r].pressure + air[rough_[r].room]);
}

}  // namespace corpuscle::gas
