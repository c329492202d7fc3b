// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// After TSW: the bag's gas at uniform pressure, its particles frozen.

#include <algorithm>
#include <cmath>

#include "gas/bag_gas.hpp"
#include "solver/base/error.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {

bool BagGas::switches(double t) const {
    constexpr double ROUNDING = 1e-12;  // t is a sum of many steps
    return !uniform_ && t >= card_.switch_at * (1.0 - ROUNDING);
}

/// Mass, energy and so temperature stay as they are; motion becomes heat.
/// Uniform pressure takes the place of that which hits made one expect; what they have brought
/// beyond it is still released.
void BagGas::become_uniform(const Points& x) {
    std::vector<Species> kinds = inflators_.species();
    if (air_) kinds.push_back(air_->species());
    if (kinds.empty()) return;
    ControlVolume all(std::move(kinds));
    for (std::size_t s = 0; s < mass_.size(); ++s) {
        const auto kind = static_cast<std::int32_t>(s);
        const auto count = static_cast<double>(
            std::count(particles_.species.begin(), particles_.species.end(), kind));
        all.add(s, count * inflators_.moles_each(), energy_of(kind));
    }
    if (air_) all.add(mass_.size(), air_->moles(), air_->energy());
    settle(all, enclosure_.volume(x));
    store_.end_of_hits();
    uniform_ = std::move(all);
    for (std::size_t i = 0; i < particles_.size(); ++i) {
        particles_.e[i] += 0.5 * mass_[particles_.species[i]] * particles_.v[i].squaredNorm();
        particles_.v[i].setZero();
    }
}

void BagGas::settle(ControlVolume& gas, double volume) const {
    if (!gas.settle(volume))
        throw PhysicsError(
            time_,
            fmt::format("*AIRBAG_PARTICLE {}: at uniform pressure the volume is {:g} and the gas "
                        "holds {:g} of energy",
                        card_.id, volume, gas.energy()));
}

/// Gas flows in by its curve; the smoothing account is paid back as fast as impulse is released.
void BagGas::flow_uniform(double t, double dt, const Points& x) {
    for (std::size_t s = 0; s < inflators_.inflows(); ++s) {
        const double mass = inflators_.mass_until(s, t + dt) - inflators_.mass_until(s, t);
        if (!(mass > 0.0)) continue;
        const double energy = mass * inflators_.enthalpy(s, t + 0.5 * dt);
        uniform_->add(s, mass / inflators_.species()[s].molar_mass(), energy);
        inflow_energy_ += energy;
        mass_in_ += mass;
    }
    const double heat = -std::expm1(-dt / store_.time()) * (taken_ - given_);
    uniform_->add_heat(heat);
    taken_ -= heat;
    if (!openings_.empty() || !heat_loss_.empty()) let_out_uniform(t, dt, x);
}

double BagGas::uniform_work(const Points& v_mid, double span) const {
    const auto nodes = enclosure_.nodes();
    return air_pressure() * span * parallel::sum(nodes.size(), 0.0, [&](std::size_t i) {
               return area_[nodes[i]].dot(v_mid[nodes[i]]);
           });
}

GasState BagGas::uniform_state(const Points& x) const {
    GasState now;
    now.volume = enclosure_.volume(x);
    now.area = enclosure_.area(x);
    now.mass_in = mass_in_;
    now.mass_out_vent = openings_.mass_out(true);
    now.mass_out_fabric = openings_.mass_out(false);
    now.particles_out = static_cast<double>(openings_.particles_out());
    now.mass = uniform_->mass();
    now.pressure = uniform_->pressure();
    now.temperature = uniform_->temperature();
    now.energy = uniform_->energy();
    now.translational = 1.5 * now.pressure * now.volume;
    const auto include = [&](std::size_t s) {
        const double T = now.temperature;
        now.species.push_back({uniform_->mass(s), uniform_->moles(s) > 0.0 ? T : 0.0,
                               uniform_->moles(s) * uniform_->species()[s].molar_energy()(T)});
    };
    if (card_.air) include(inflators_.inflows());
    for (std::size_t s = 0; s < inflators_.inflows(); ++s) include(s);
    return now;
}

}  // namespace corpuscle::gas
