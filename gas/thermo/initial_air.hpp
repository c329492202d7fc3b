// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/cards/bag.hpp"
#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// Air in the bag at the start (IAIR = 1): a control volume at uniform pressure p = n R T / V.
///
/// It works on the fabric, E -= p dV, and shares heat with the particles so that both stay at one
/// mean temperature [notes, "Initial air"].
class InitialAir {
public:
    /// n = p V / (R T) moles at the card's pressure and temperature.
    InitialAir(const InitialAirCard& card, double gas_constant, double volume)
        : species_(card.species, gas_constant, "initial air"),
          moles_(card.pressure * volume / (gas_constant * card.temperature)),
          energy_(moles_ * species_.molar_energy()(card.temperature)),
          temperature_(card.temperature) {}

    [[nodiscard]] double pressure(double volume) const {  ///< [Pa]
        return moles_ * species_.gas_constant() * temperature_ / volume;
    }
    [[nodiscard]] double temperature() const { return temperature_; }             ///< [K]
    [[nodiscard]] double energy() const { return energy_; }                       ///< [J]
    [[nodiscard]] double mass() const { return moles_ * species_.molar_mass(); }  ///< [kg]
    [[nodiscard]] double moles() const { return moles_; }
    [[nodiscard]] double translational() const {  ///< (3/2) n R T                      [J]
        return 1.5 * moles_ * species_.gas_constant() * temperature_;
    }
    [[nodiscard]] const Species& species() const { return species_; }
    /// Energy of the air as a polynomial in its temperature.
    [[nodiscard]] EnergyPolynomial content() const { return moles_ * species_.molar_energy(); }

    /// Ambient air flows in, with its enthalpy; returns that.               [kg], [K] -> [J]
    double take_in(double mass, double T_ambient) {
        const double brought = mass * species_.h(T_ambient);
        moles_ += mass / species_.molar_mass();
        add(brought);
        return brought;
    }

    /// Air flows in from another room, with the energy that it brings.                 [kg], [J]
    void receive(double mass, double energy) {
        moles_ += mass / species_.molar_mass();
        add(energy);
    }

    /// Takes up heat (or gives it, or work, when negative).                              [J]
    void add(double energy) {
        energy_ += energy;
        temperature_ = content().temperature(energy_, temperature_);
    }

    /// Lets `mass` go, each mole with u + heat · R T; returns the energy that goes with it.   [J]
    double release(double mass, double heat) {
        const double out = mass / species_.molar_mass();
        const double energy =
            out * (energy_ / moles_ + heat * species_.gas_constant() * temperature_);
        moles_ -= out;
        add(-energy);
        return energy;
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(moles_, energy_, temperature_);
    }

private:
    Species species_;
    double moles_;        ///< [mol]
    double energy_;       ///< [J]
    double temperature_;  ///< [K]
};

}  // namespace corpuscle::gas
