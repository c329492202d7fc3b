// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Gas that leaves a bag, and its energy.

#include <algorithm>
#include <cmath>

#include "gas/bag_gas.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::gas {

/// Mean state of particles and air, for the openings: p and T of the gas come to rest. They change
/// with what flows only; the pressure of this instant trembles about them, and a vent that answers
/// to it would let gas out, never in, by chance.
void BagGas::look_inside(const Points& x) {
    looked_at_ = collisions_;
    const GasState now = state(x);
    inside_.temperature = now.temperature;
    inside_.is_uniform = is_uniform();
    double moles = 0.0, heat = 0.0;  // heat: capacity at constant pressure                [J/K]
    const auto include = [&](double mass, const Species& gas) {
        moles += mass / gas.molar_mass();
        heat += mass * gas.cp(now.temperature);
    };
    inside_.density.resize(mass_.size());
    for (std::size_t s = 0; s < mass_.size(); ++s) {
        // Initial air stands first among all, and last among the particles' gases.
        const bool is_air = s == inflators_.inflows();
        const double mass = now.species[is_air ? 0 : s + (card_.air ? 1 : 0)].mass;
        inside_.density[s] = mass / now.volume;
        include(mass, inflators_.species()[s]);
    }
    if (air_) {
        inside_.air_density = now.species[0].mass / now.volume;
        inside_.air_molar_mass = air_->species().molar_mass();
        include(now.species[0].mass, air_->species());
    }
    inside_.pressure = moles * card_.gas_constant * now.temperature / now.volume;
    inside_.molar_mass = moles > 0.0 ? now.mass / moles : 0.0;
    inside_.heat_capacity = heat - moles * card_.gas_constant;
    inside_.gamma = moles > 0.0 ? heat / (heat - moles * card_.gas_constant) : 0.0;
}

/// Takes out who has passed, books the energy, and remembers what the rest owes to it.
void BagGas::let_out(double dt) {
    const Openings::Passed& passed = openings_.count(flight_, dt, inside_, particles_.species);
    lost_energy_ += passed.energy;
    owed_to_outflow_ += passed.still_owed;
    gone_.insert(gone_.end(), passed.rows.begin(), passed.rows.end());
    if (!air_) return;
    if (const double mass = openings_.intake() * dt; mass > 0.0) {
        inflow_energy_ += air_->take_in(mass, card_.T_atm);
        mass_in_ += mass;
    }
    const Openings::Air air = openings_.air_leaving(dt);
    if (air.mass <= 0.0) return;
    // What has left in dt at a rate that falls with what is left.
    const double mass = -air_->mass() * std::expm1(-air.mass / air_->mass());
    const double energy = air_->release(mass, air.heat);
    openings_.book_air(mass);
    lost_energy_ += energy;
}

/// Heat that the fabric takes, to be drawn from the gas at the next collision step; from the air at
/// once where there are no particles.
void BagGas::cool(double t, double dt, const Points& x) {
    owed_to_outflow_ += heat_loss_.lose(t, dt, x, inside_);
    if (air_ && particles_.size() == 0) air_->add(pay_outflow(air_->energy()));
}

/// What has left owes, enthalpy that it did not take along and heat: the gas that stays pays, but
/// no more than `left`. Returns what that is to it.
double BagGas::pay_outflow(double left) {
    const double paid = std::min(owed_to_outflow_, left);
    owed_to_outflow_ -= paid;
    lost_energy_ += paid;
    return -paid;
}

}  // namespace corpuscle::gas
