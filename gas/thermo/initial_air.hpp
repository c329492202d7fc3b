// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <utility>

#include "gas/cards/bag.hpp"
#include "gas/thermo/control_volume.hpp"
#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// Air in a room of a bag at the start (IAIR = 1): a control volume at uniform pressure
/// p = n R T / V.
///
/// It works on the fabric, E -= p dV, and shares heat with the particles so that both stay at one
/// mean temperature [notes, "Initial air"]. In step with the leapfrog as a ControlVolume: settle()
/// finds the state at t, work() books that of the kick from t - dt/2 to t + dt/2; heat and mass
/// that come or go between two calls of settle() change the state at once.
class InitialAir {
public:
    /// n = p V / (R T) moles at the card's pressure and temperature; none in a room without volume.
    InitialAir(const InitialAirCard& card, double gas_constant, double volume)
        : species_(card.species, gas_constant, "initial air"),
          moles_(volume > 0.0 ? card.pressure * volume / (gas_constant * card.temperature) : 0.0),
          energy_(moles_ * species_.molar_energy()(card.temperature)),
          at_t_{energy_, card.temperature, moles_ > 0.0 ? card.pressure : 0.0},
          volume_(volume) {}

    /// Finds T and p at t, when the air fills `volume`. False when there is no such state: no
    /// volume, or an energy that belongs to no temperature. No air needs none.          [m^3]
    [[nodiscard]] bool settle(double volume) {
        const double before = std::exchange(volume_, volume);
        if (moles_ == 0.0) {
            at_t_.energy = energy_;
            at_t_.pressure = 0.0;
            return true;
        }
        if (!(volume > 0.0)) return false;
        at_t_ = settled_state(content(), moles_ * species_.gas_constant(), energy_,
                              at_t_.temperature, before, volume);
        return at_t_.temperature >= 0.0 && at_t_.pressure < INF;
    }
    /// The walls have moved by `swept` under the pressure of settle().                 [m^3]
    void work(double swept) { energy_ -= at_t_.pressure * swept; }

    /// Absolute, at t, as settle() found it.                                          [Pa]
    [[nodiscard]] double pressure() const { return at_t_.pressure; }
    /// At t, with what has come and gone since.                                        [K]
    [[nodiscard]] double temperature() const { return at_t_.temperature; }
    /// That it filled at t.                                                          [m^3]
    [[nodiscard]] double volume() const { return volume_; }
    /// All that the air holds at t, with what has come and gone since.                 [J]
    [[nodiscard]] double energy() const { return at_t_.energy; }
    /// Of which work() has taken since settle().                                       [J]
    [[nodiscard]] double worked() const { return at_t_.energy - energy_; }
    [[nodiscard]] double mass() const { return moles_ * species_.molar_mass(); }  ///< [kg]
    [[nodiscard]] double moles() const { return moles_; }                         ///< [mol]
    [[nodiscard]] double translational() const {  ///< (3/2) n R T                      [J]
        return 1.5 * moles_ * species_.gas_constant() * at_t_.temperature;
    }
    /// What the air is of.
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

    /// Takes up heat, or gives it when negative.                                          [J]
    void add(double energy) {
        energy_ += energy;
        at_t_.energy += energy;
        if (moles_ > 0.0)
            at_t_.temperature = content().temperature(at_t_.energy, at_t_.temperature);
    }

    /// Lets `mass` go, each mole with u + heat · R T; returns the energy that goes with it.   [J]
    double release(double mass, double heat) {
        const double out = mass / species_.molar_mass();
        const double energy =
            out * (at_t_.energy / moles_ + heat * species_.gas_constant() * at_t_.temperature);
        moles_ -= out;
        add(-energy);
        return energy;
    }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(moles_, energy_, at_t_.energy, at_t_.temperature, at_t_.pressure, volume_);
    }

private:
    Species species_;
    double moles_;       ///< [mol]
    double energy_;      ///< half a step after t once work() is booked                 [J]
    SettledState at_t_;  ///< with what has come and gone since
    double volume_;      ///< at t                                                    [m^3]
};

}  // namespace corpuscle::gas
