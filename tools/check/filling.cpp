// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/check/filling.hpp"

#include <algorithm>
#include <cmath>

#include "gas/inflow/flow_curve.hpp"
#include "solver/model.hpp"

namespace corpuscle::tools {

Filling& Filling::operator+=(const Filling& o) {
    mass += o.mass;
    moles += o.moles;
    energy += o.energy;
    heat += o.heat;
    gas += o.gas;
    coldest = std::min(coldest, o.coldest);
    hottest = std::max(hottest, o.hottest);
    return *this;
}

double Filling::thermal_speed() const {
    return mass > 0.0 ? std::sqrt(gas / heat * energy / mass) : NaN;
}

void add_inflow(Filling& all, const Curve& rate, double end, double until,
                const gas::Species& species, const std::function<double(double)>& temperature) {
    const gas::FlowCurve flow(rate, end);
    constexpr int STEPS = 200;
    const double first = flow.begins(), last = std::min({until, end, flow.ends()});
    for (int i = 0; i < STEPS; ++i) {
        const double a = first + (last - first) * i / STEPS,
                     b = first + (last - first) * (i + 1) / STEPS;
        const double mass = flow.sum_until(b) - flow.sum_until(a);
        if (!(mass > 0.0)) continue;
        const double T = temperature(0.5 * (a + b));
        const double moles = mass / species.molar_mass();
        all.mass += mass;
        all.moles += moles;
        all.energy += mass * species.h(T);
        all.heat += mass * species.cv(T);
        all.gas += moles * species.gas_constant();
        all.coldest = std::min(all.coldest, T);
        all.hottest = std::max(all.hottest, T);
    }
}

Filling inflow_until(const Model& model, const gas::BagCard& card, double until) {
    Filling in;
    for (const gas::InflowCard& flow : card.inflow)
        add_inflow(in, model.curves[flow.mass_rate], card.all_in, until,
                   gas::Species(flow.species, card.gas_constant, "gas"),
                   [&](double t) { return model.curves[flow.temperature](t); });
    return in;
}

Filling air_in(const gas::BagCard& card, double volume) {
    Filling in;
    if (!card.air) return in;
    const gas::Species air(card.air->species, card.gas_constant, "air");
    const double T = card.air->temperature;
    in.moles = card.air->pressure * volume / (card.gas_constant * T);
    in.mass = in.moles * air.molar_mass();
    in.energy = in.moles * air.molar_energy()(T);
    in.heat = in.mass * air.cv(T);
    in.gas = in.moles * card.gas_constant;
    in.coldest = in.hottest = T;
    return in;
}

double full_volume(double now, double area) {
    constexpr double MYLAR = 0.0774;
    return std::max(now, MYLAR * std::pow(area, 1.5));
}

}  // namespace corpuscle::tools
