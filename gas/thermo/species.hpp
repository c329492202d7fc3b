// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"

namespace corpuscle::gas {

/// Energy as a cubic in temperature, E(T) = a T + b T² + c T³: of a mole, of a particle, of a
/// mixture. Sums of such energies are sums of their coefficients, so a mixture costs no more than
/// one gas.
struct EnergyPolynomial {
    double a = 0.0;  ///< [J/K]
    double b = 0.0;  ///< [J/K^2]
    double c = 0.0;  ///< [J/K^3]

    /// E at T [K].                                                                            [J]
    [[nodiscard]] double operator()(double T) const { return ((c * T + b) * T + a) * T; }
    /// dE/dT at T: the heat capacity.                                                       [J/K]
    [[nodiscard]] double slope(double T) const { return (3.0 * c * T + 2.0 * b) * T + a; }
    /// d²E/dT² at T.                                                                      [J/K^2]
    [[nodiscard]] double curvature(double T) const { return 6.0 * c * T + 2.0 * b; }

    /// Energy of both together.
    EnergyPolynomial& operator+=(const EnergyPolynomial& o) {
        a += o.a;
        b += o.b;
        c += o.c;
        return *this;
    }
    /// Energy of s times as much.
    friend EnergyPolynomial operator*(double s, const EnergyPolynomial& p) {
        return {s * p.a, s * p.b, s * p.c};
    }

    /// The temperature T >= 0 where the energy, rising, reaches `energy`; NaN when it never does
    /// (a negative energy, or one above the fit's maximum). Newton inside a bracket, exact to
    /// rounding. Cost: one division an iteration, 1-4 iterations from a fair guess.
    [[nodiscard]] double temperature(double energy, double guess = 300.0) const;
};

/// One ideal gas with Cp(T) = A + B T + C T² per mole: what it holds at a temperature.
///
///     u(T) = ((A - R) T + B T²/2 + C T³/3) / M,   h = u + R T / M       [PHYSICS, section 1]
///
/// u(0) = 0. The part of u that is not translation, internal(T) = u - 3/2 R T / M (eq. 18-21), may
/// be a trifle negative where a deck rounds a monatomic gas's A below 5/2 R; it is carried as it
/// is.
class Species {
public:
    /// @param gas_constant  R in the card's units                                     [J/(mol K)]
    /// @throws InputError  naming the gas by `name`, when a number is missing or M or R is not
    ///                     positive
    Species(const SpeciesCard& card, double gas_constant, std::string name);

    /// For messages.
    [[nodiscard]] const std::string& name() const { return name_; }
    [[nodiscard]] double molar_mass() const { return M_; }    ///< M        [kg/mol]
    [[nodiscard]] double gas_constant() const { return R_; }  ///< R  [J/(mol K)]
    /// Heat capacity at constant pressure.                                            [J/(kg K)]
    [[nodiscard]] double cp(double T) const { return ((C_ * T + B_) * T + A_) / M_; }
    /// Heat capacity at constant volume.                                              [J/(kg K)]
    [[nodiscard]] double cv(double T) const { return cp(T) - R_ / M_; }
    [[nodiscard]] double gamma(double T) const { return cp(T) / cv(T); }  ///< cp / cv         [-]
    /// Energy of the gas at rest.                                                         [J/kg]
    [[nodiscard]] double u(double T) const { return molar_energy()(T) / M_; }
    /// Enthalpy.                                                                          [J/kg]
    [[nodiscard]] double h(double T) const { return u(T) + R_ * T / M_; }
    /// Energy of spin and vibration.                                                      [J/kg]
    [[nodiscard]] double internal(double T) const { return molar_internal()(T) / M_; }

    /// Same molar mass, same heat capacity.
    [[nodiscard]] bool is_like(const Species& o) const {
        return M_ == o.M_ && A_ == o.A_ && B_ == o.B_ && C_ == o.C_;
    }

    /// T where u(T) = `specific_energy` [J/kg]; NaN when there is none.                   [K]
    [[nodiscard]] double temperature_of(double specific_energy) const;

    /// T_stag with u(T_stag) = h(T_static) (eq. 28, for any heat capacity).               [K]
    [[nodiscard]] double stagnation_temperature(double T_static) const {
        return temperature_of(h(T_static));
    }

    /// All energy and its internal (spin + vibration) part, of a mole.
    [[nodiscard]] EnergyPolynomial molar_energy() const { return {A_ - R_, B_ / 2, C_ / 3}; }
    /// The internal part: A - 5/2 R in the place of A - R.
    [[nodiscard]] EnergyPolynomial molar_internal() const {
        return {A_ - 2.5 * R_, B_ / 2, C_ / 3};
    }

    /// What is wrong with the heat capacity between `low` and `high` [K], in the user's words, or
    /// empty: Cv must be positive and Cp/Cv at most 5/3 (eq. 21), plus 0.2 % for a deck's rounded
    /// 5/2 R.
    [[nodiscard]] std::string fault_between(double low, double high) const;

private:
    double R_, M_, A_, B_, C_;
    std::string name_;
};

/// The gases of a bag, as particles: all stand for the same number of moles.
class Mixture {
public:
    /// @param species     one at least, by row
    /// @param moles_each  that a particle stands for, > 0                                     [mol]
    Mixture(std::vector<Species> species, double moles_each);

    /// The first species that is alike in molar mass and heat capacity: collisions cannot tell gas
    /// of one kind apart, by whatever inflow it came.
    [[nodiscard]] std::int32_t kind(std::int32_t s) const { return kind_[s]; }

    /// As it was built with.
    [[nodiscard]] const std::vector<Species>& species() const { return species_; }
    /// That a particle stands for.                                                         [mol]
    [[nodiscard]] double moles_each() const { return moles_each_; }
    /// Of one particle of a species, by row.                                                [kg]
    [[nodiscard]] double particle_mass(std::int32_t s) const { return mass_[s]; }
    /// Internal (spin + vibration) energy of a particle at equilibrium, over temperature.
    [[nodiscard]] const EnergyPolynomial& particle_internal(std::int32_t s) const {
        return internal_[s];
    }
    /// Translational energy of a particle at equilibrium, per degree of freedom: R moles / 2. [J/K]
    [[nodiscard]] double half_heat() const { return half_heat_; }
    /// Temperature of one particle: at which it would hold `internal` in spin and vibration; of a
    /// gas that has less than a twentieth of a degree of freedom in them at `internal`, or holds no
    /// such energy, that of its own speed, m v² / (6 half_heat).                            [K]
    [[nodiscard]] double particle_temperature(std::int32_t s, double internal,
                                              double speed_squared) const;

private:
    std::vector<Species> species_;
    double moles_each_, half_heat_ = 0.0;
    std::vector<std::int32_t> kind_;
    std::vector<double> mass_;
    std::vector<EnergyPolynomial> internal_;
};

/// Temperature at which moles[s] of each species hold `energy` together; NaN when there is none.
/// [K]
double mixture_temperature(std::span<const Species> species, std::span<const double> moles,
                           double energy);

}  // namespace corpuscle::gas
