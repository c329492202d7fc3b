// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/exchange.hpp"

#include <cmath>

#include "gas/thermo/orifice_flow.hpp"
#include "solver/base/surface.hpp"

namespace corpuscle::gas {

double area_of(std::span<const std::array<Index, 4>> facets, const Points& x) {
    double area = 0.0;
    for (const auto& [a, b, c, d] : facets) {
        area += vector_area(x[a], x[b], x[c]).norm();
        if (c != d) area += vector_area(x[a], x[c], x[d]).norm();
    }
    return area;
}

/// Mass flow at t.                                                                       [kg/s]
double Exchange::rate(double t, const Points& x, const UniformBag& from,
                      const UniformBag& to) const {
    const double p = from.pressure(), p_to = to.pressure();
    if (card_.rate >= 0) return curves_[card_.rate](p - p_to);
    const ExitCard& hole = card_.opening;
    const double area = hole.facets.empty() ? value(hole.area, p) : area_of(hole.facets, x);
    const ControlVolume& gas = from.gas();
    return value(hole.coefficient, t) * area *
           orifice_flow(p, p_to, gas.temperature(), gas.gamma(), gas.gas_constant());
}

void Exchange::flow(double t, double dt, const Points& x, std::span<UniformBag> bags) const {
    UniformBag &first = bags[card_.bags[0]], &second = bags[card_.bags[1]];
    const bool is_forward = first.pressure() > second.pressure();
    if (card_.direction != 0 && is_forward != (card_.direction < 0)) return;
    UniformBag &from = is_forward ? first : second, &to = is_forward ? second : first;
    const double step = rate(t, x, from, to) * dt;
    if (!(step > 0.0)) return;
    const ControlVolume& gas = from.gas();
    const double equal =
        (from.pressure() - to.pressure()) / (gas.gamma() * gas.gas_constant() * gas.temperature() *
                                             (1.0 / gas.volume() + 1.0 / to.gas().volume()));
    from.give(-std::expm1(-step / equal) * equal, dt, to);
}

}  // namespace corpuscle::gas
