// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/wall_load/roughness.hpp"

#include <algorithm>
#include <cmath>

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

Roughness::Roughness(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves,
                     double time)
    : pushes_along_(card.friction_pushes_along), time_(time) {
    if (card.friction.empty()) return;
    std::vector<double> factor(walls.part_rows.size(), 0.0);
    rough_of_.assign(walls.part_rows.size(), -1);
    for (std::size_t p = 0; p < factor.size(); ++p) {
        const FrictionCard* friction = card_for(card.friction, walls.part_rows[p]);
        if (friction == nullptr) continue;
        factor[p] = friction->factor;
        if (friction->curve < 0) continue;
        factor[p] = curves[friction->curve](0.0);
        rough_of_[p] = static_cast<Index>(rough_.size());
        rough_.push_back({static_cast<Index>(p), curves[friction->curve]});
    }
    for (const Index p : walls.part) of_facet_.push_back(factor[p]);
    if (rough_.empty()) return;
    triangles_ = walls.triangles;
    part_ = walls.part;
}

void Roughness::receive(const FlightResult& flight, double dt, double air,
                        std::span<const Vec3> x) {
    if (rough_.empty()) return;
    for (Rough& part : rough_) part.impulse = part.area = 0.0;
    for (const auto& hits : flight.hits)
        for (const Hit& hit : hits)
            if (const Index r = rough_of_[part_[hit.facet]]; r >= 0) {
                const auto& [a, b, c] = triangles_[hit.facet];
                rough_[r].impulse +=
                    std::abs(hit.impulse.dot(vector_area(x[a], x[b], x[c]).normalized()));
            }
    for (std::size_t f = 0; f < triangles_.size(); ++f) {
        const auto& [a, b, c] = triangles_[f];
        if (const Index r = rough_of_[part_[f]]; r >= 0)
            rough_[r].area += vector_area(x[a], x[b], x[c]).norm();
    }
    const double fresh = -std::expm1(-dt / time_);
    for (Rough& part : rough_) {
        if (part.area > 0.0)
            part.pressure += fresh * (part.impulse / (dt * part.area) - part.pressure);
    }
    for (std::size_t f = 0; f < part_.size(); ++f)
        if (const Index r = rough_of_[part_[f]]; r >= 0)
            of_facet_[f] = rough_[r].over_pressure(rough_[r].pressure + air);
}

}  // namespace corpuscle::gas
