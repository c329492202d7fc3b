// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cassert>
#include <span>
#include <vector>

#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// State at t of a gas in a volume that moves.
struct SettledState {
    double energy;       ///< [J]
    double temperature;  ///< NaN: the energy belongs to none  [K]
    double pressure;     ///< [Pa]
};

/// State at t of a gas whose energy is that at t - dt/2: what is left to t is p dV/2, with a
/// pressure that two corrections make that of t to second order.
/// @param holds  energy of the gas as a polynomial in its temperature
/// @param nR     moles times the gas constant                                        [J/K]
/// @param guess  of its temperature                                                    [K]
/// @param before, volume  at t - dt and at t; before NaN: nothing is left to t       [m^3]
[[nodiscard]] SettledState settled_state(const EnergyPolynomial& holds, double nR, double energy,
                                         double guess, double before, double volume);

/// A mixture at one pressure and one temperature in a volume that moves.
///
///     p V = sum n_s R T,   dE = sum h_s dm_s - p dV
///
/// Works in step with the leapfrog: pressure is wanted at t, while the work of a kick is that from
/// t - dt/2 to t + dt/2. settle() finds the state at t; work() books the kick's.
class ControlVolume {
public:
    /// Empty of gas at first.
    /// @param species  one at least, all of the same gas constant R
    explicit ControlVolume(std::vector<Species> species)
        : species_(std::move(species)), moles_(species_.size(), 0.0) {
        assert(!species_.empty());
    }

    /// Adds gas of one species with all the energy that it carries.                  [mol], [J]
    void add(std::size_t species, double moles, double energy) {
        moles_[species] += moles;
        energy_ += energy;
    }
    /// Adds heat, to all the gas alike.                                                [J]
    void add_heat(double energy) { energy_ += energy; }

    /// Gas that flows out as it is, with its enthalpy: a share of every species. Returns the energy
    /// that goes with it.                                                                    [J]
    double remove(double mass);

    /// Finds T and p at t, when the gas fills `volume`. False when there is no such state: no
    /// volume, or an energy that belongs to no temperature.
    [[nodiscard]] bool settle(double volume);

    /// The walls have moved by `swept` under the pressure of settle(); returns -dE.  [m^3] -> [J]
    double work(double swept) {
        energy_ -= pressure_ * swept;
        return pressure_ * swept;
    }

    /// Absolute, at t, as settle() found it.                                          [Pa]
    [[nodiscard]] double pressure() const { return pressure_; }
    /// Of all species alike, at t.                                                     [K]
    [[nodiscard]] double temperature() const { return temperature_; }
    /// That the gas fills at t.                                                      [m^3]
    [[nodiscard]] double volume() const { return volume_; }
    /// All that the gas holds at t, 0 at 0 K.                                          [J]
    [[nodiscard]] double energy() const { return energy_at_t_; }

    /// As it was built with.
    [[nodiscard]] const std::vector<Species>& species() const { return species_; }
    /// Of one species, by row.                                                      [mol]
    [[nodiscard]] double moles(std::size_t species) const { return moles_[species]; }
    /// Of all species.                                                              [mol]
    [[nodiscard]] double moles() const;
    /// Of one species, by row.                                                       [kg]
    [[nodiscard]] double mass(std::size_t s) const { return moles_[s] * species_[s].molar_mass(); }
    [[nodiscard]] double mass() const;      ///< of all species              [kg]
    [[nodiscard]] double gamma() const;     ///< Cp / Cv of the mixture at T              [-]
    [[nodiscard]] double enthalpy() const;  ///< u + R T / M at T                        [J/kg]
    /// R / M of the mixture.                                                       [J/(kg K)]
    [[nodiscard]] double gas_constant() const { return R() * moles() / mass(); }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(moles_, energy_, energy_at_t_, volume_, temperature_, pressure_);
    }

private:
    [[nodiscard]] double R() const { return species_[0].gas_constant(); }
    [[nodiscard]] EnergyPolynomial content() const;

    std::vector<Species> species_;
    std::vector<double> moles_;
    double energy_ = 0.0;       ///< half a step after t once work() is booked            [J]
    double energy_at_t_ = 0.0;  ///< [J]
    double volume_ = NaN, temperature_ = 300.0, pressure_ = NaN;
};

}  // namespace corpuscle::gas
