// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/thermo/control_volume.hpp"

#include <algorithm>
#include <numeric>

namespace corpuscle::gas {

SettledState settled_state(const EnergyPolynomial& holds, double nR, double energy, double guess,
                           double before, double volume) {
    const double half = std::isnan(before) ? 0.0 : 0.5 * (volume - before);
    const double freedom = nR / volume;
    SettledState now{energy, guess, 0.0};
    for (int correction = 0; correction < 2; ++correction) {
        now.temperature = holds.temperature(now.energy, now.temperature);
        now.pressure = freedom * now.temperature;
        if (half == 0.0) return now;
        now.energy = energy - now.pressure * half;
    }
    now.temperature = holds.temperature(now.energy, now.temperature);
    now.pressure = freedom * now.temperature;
    return now;
}

EnergyPolynomial ControlVolume::content() const {
    EnergyPolynomial all;
    for (std::size_t s = 0; s < species_.size(); ++s) all += moles_[s] * species_[s].molar_energy();
    return all;
}

double ControlVolume::moles() const {
    return std::accumulate(moles_.begin(), moles_.end(), 0.0);
}

double ControlVolume::mass() const {
    double sum = 0.0;
    for (std::size_t s = 0; s < species_.size(); ++s) sum += mass(s);
    return sum;
}

double ControlVolume::gamma() const {
    return 1.0 + R() * moles() / content().slope(temperature_);
}

double ControlVolume::enthalpy() const {
    return (content()(temperature_) + R() * moles() * temperature_) / mass();
}

double ControlVolume::remove(double mass) {
    const double there = this->mass();
    assert(mass <= there);
    const double gone = mass * enthalpy();
    for (double& moles : moles_) moles -= moles * (mass / there);
    energy_ -= gone;
    return gone;
}

bool ControlVolume::settle(double volume) {
    if (moles() == 0.0) {
        energy_at_t_ = energy_;
        volume_ = volume;
        pressure_ = 0.0;
        return volume > 0.0;
    }
    const SettledState now =
        settled_state(content(), R() * moles(), energy_, temperature_, volume_, volume);
    energy_at_t_ = now.energy;
    temperature_ = now.temperature;
    pressure_ = now.pressure;
    volume_ = volume;
    return volume > 0.0 && temperature_ >= 0.0 && pressure_ < INF;
}

}  // namespace corpuscle::gas
