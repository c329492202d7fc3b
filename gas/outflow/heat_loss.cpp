// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/outflow/heat_loss.hpp"

#include <algorithm>
#include <cmath>

namespace corpuscle::gas {

HeatLoss::HeatLoss(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves)
    : part_heat_(walls.part_ids.size(), 0.0), T_atm_(card.T_atm) {
    if (card.heat.empty()) return;
    triangles_ = walls.triangles;
    for (const HeatCard& heat : card.heat)
        for (std::size_t p = 0; p < walls.part_rows.size(); ++p) {
            const auto& parts = heat.parts;
            if (std::find(parts.begin(), parts.end(), walls.part_rows[p]) == parts.end()) continue;
            Cooled cooled{heat.coefficient,
                          heat.curve >= 0 ? curves[heat.curve] : Curve{},
                          static_cast<Index>(p),
                          {},
                          0.0};
            for (std::size_t f = 0; f < walls.triangles.size(); ++f)
                if (walls.part[f] == cooled.part) cooled.facets.push_back(static_cast<Index>(f));
            cooled_.push_back(std::move(cooled));
        }
}

double HeatLoss::lose(double t, double dt, std::span<const Vec3> x, const Inside& inside) {
    if (!inside.holds_gas()) return 0.0;
    double sum = 0.0;
    for (Cooled& cooled : cooled_) {
        double area = 0.0;
        for (const Index f : cooled.facets) {
            const auto& [a, b, c] = triangles_[f];
            area += vector_area(x[a], x[b], x[c]).norm();
        }
        const double h = cooled.over_time.empty() ? cooled.coefficient : cooled.over_time(t);
        cooled.power_per_kelvin = h * area;
        sum += cooled.power_per_kelvin;
    }
    if (sum == 0.0) return 0.0;
    const double heat = -inside.heat_capacity * (inside.temperature - T_atm_) *
                        std::expm1(-sum * dt / inside.heat_capacity);
    for (const Cooled& cooled : cooled_)
        part_heat_[cooled.part] += heat * cooled.power_per_kelvin / sum;
    return heat;
}

}  // namespace corpuscle::gas
