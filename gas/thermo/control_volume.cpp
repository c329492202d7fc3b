// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/thermo/control_volume.hpp"

#include <algorithm>
#include <numeric>

namespace corpuscle::gas {

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

/// The gas has worked up to t - dt/2: what is left to t is p dV/2, with a pressure that one
/// correction makes that of t to second order.
bool ControlVolume::settle(double volume) {
    if (moles() == 0.0) {
        energy_at_t_ = energy_;
        volume_ = volume;
        pressure_ = 0.0;
        return volume > 0.0;
    }
    const double half = std::isnan(volume_) ? 0.0 : 0.5 * (volume - volume_);
    const EnergyPolynomial holds = content();
    const double freedom = R() * moles() / volume;
    energy_at_t_ = energy_;
    for (int correction = 0; correction < 2; ++correction) {
        temperature_ = holds.temperature(energy_at_t_, temperature_);
        pressure_ = freedom * temperature_;
        if (half == 0.0) break;
        energy_at_t_ = energy_ - pressure_ * half;
    }
    if (half != 0.0) {
        temperature_ = holds.temperature(energy_at_t_, temperature_);
        pressure_ = freedom * temperature_;
    }
    volume_ = volume;
    return volume > 0.0 && temperature_ >= 0.0 && pressure_ < INF;
}

}  // namespace corpuscle::gas
