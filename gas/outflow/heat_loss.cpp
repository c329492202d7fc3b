// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/outflow/heat_loss.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::gas {

HeatLoss::HeatLoss(const BagCard& card, const BagWalls& walls, const WettedSurface& surface,
                   const WallSamples& samples, std::span<const Curve> curves)
    : per_room_(surface.rooms(), 0.0), part_heat_(walls.part_ids.size(), 0.0), T_atm_(card.T_atm) {
    for (const HeatCard& heat : card.heat)
        for (std::size_t k = 0; k < samples.patches().size(); ++k) {
            const Index side = samples.patches()[k][0];
            const Index part = walls.part[surface.facet(side)];
            const auto& parts = heat.parts;
            if (std::find(parts.begin(), parts.end(), walls.part_rows[part]) == parts.end())
                continue;
            cooled_.push_back({heat.coefficient, heat.curve >= 0 ? curves[heat.curve] : Curve{},
                               part, static_cast<Index>(k), surface.room(side)});
        }
}

const std::vector<HeatLoss::Taken>& HeatLoss::lose(double t, double dt, const WallSamples& samples,
                                                   std::span<const Inside> rooms) {
    taken_.clear();
    std::fill(per_room_.begin(), per_room_.end(), 0.0);
    const auto power = [&](const Cooled& cooled) {
        const double h = cooled.over_time.empty() ? cooled.coefficient : cooled.over_time(t);
        return h * samples.area(static_cast<std::size_t>(cooled.sample));
    };
    for (const Cooled& cooled : cooled_) per_room_[cooled.room] += power(cooled);
    for (const Cooled& cooled : cooled_) {
        const Inside& room = rooms[cooled.room];
        if (!room.holds_gas()) continue;
        const bool has_air = room.air_pressure > 0.0 || room.is_uniform;
        if (!has_air && !samples.is_reached(static_cast<std::size_t>(cooled.sample))) continue;
        if (room.is_uniform)
            local_.temperature = room.temperature;
        else
            samples.state(static_cast<std::size_t>(cooled.sample), room, local_);
        const double steps = per_room_[cooled.room] * dt / room.heat_capacity;
        const double slower = steps > 0.0 ? -std::expm1(-steps) / steps : 1.0;
        const double heat = power(cooled) * slower * dt * (local_.temperature - T_atm_);
        if (heat == 0.0) continue;
        taken_.push_back({cooled.sample, cooled.room, heat});
        part_heat_[cooled.part] += heat;
    }
    return taken_;
}

}  // namespace corpuscle::gas
