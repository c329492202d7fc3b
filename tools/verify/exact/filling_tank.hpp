// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>
#include <vector>

#include "solver/base/constants.hpp"

/// A rigid tank, always mixed, into which hot gas flows and whose walls take heat: ordinary
/// differential equations.
///
///     dn/dt = m'/M,   dU/dt = m'/M H(T_in) - h A (T - T_wall),   p = sum n R T / V
namespace corpuscle::oracle {

/// Per mole: Cp = a + b T.
struct IdealGas {
    double a = 0.0, b = 0.0;
    [[nodiscard]] double enthalpy(double T) const { return (a + 0.5 * b * T) * T; }
    [[nodiscard]] double energy(double T) const { return enthalpy(T) - GAS_CONSTANT * T; }
    [[nodiscard]] double heat_capacity(double T) const { return a + b * T - GAS_CONSTANT; }
};

struct FillingTank {
    struct Content {
        IdealGas gas;
        double moles = 0.0;
    };
    std::vector<Content> contents;  ///< the last one is what flows in
    double energy = 0.0;            ///< [J]
    double volume = 0.0;            ///< [m^3]

    [[nodiscard]] double moles() const {
        double n = 0.0;
        for (const Content& c : contents) n += c.moles;
        return n;
    }
    /// Of the energy, by Newton's steps: U(T) is all but straight.
    [[nodiscard]] double temperature() const {
        double T = 300.0;
        for (int k = 0; k < 20; ++k) {
            double U = -energy, slope = 0.0;
            for (const Content& c : contents) {
                U += c.moles * c.gas.energy(T);
                slope += c.moles * c.gas.heat_capacity(T);
            }
            T -= U / slope;
        }
        return T;
    }
    [[nodiscard]] double pressure() const {
        return moles() * GAS_CONSTANT * temperature() / volume;
    }

    /// From `from` to `to`, midpoint rule. @param inflow  moles a time at t
    /// @param T_in  static temperature of the inflow at t  @param loss  heat a time at T
    void fill(double from, double to, int steps, const std::function<double(double)>& inflow,
              const std::function<double(double)>& T_in,
              const std::function<double(double)>& loss) {
        const double dt = (to - from) / steps;
        for (int k = 0; k < steps; ++k) {
            const double t = from + k * dt;
            FillingTank middle = *this;
            middle.take(t, 0.5 * dt, *this, inflow, T_in, loss);
            take(t + 0.5 * dt, dt, middle, inflow, T_in, loss);
        }
    }

private:
    void take(double t, double dt, const FillingTank& rates,
              const std::function<double(double)>& inflow,
              const std::function<double(double)>& T_in,
              const std::function<double(double)>& loss) {
        const double n = inflow(t);
        contents.back().moles += dt * n;
        energy += dt * (n * contents.back().gas.enthalpy(T_in(t)) - loss(rates.temperature()));
    }
};

}  // namespace corpuscle::oracle
