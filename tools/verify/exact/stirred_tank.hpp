// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "solver/base/constants.hpp"

/// A rigid tank of ideal gases, always mixed, that empties: ordinary differential equations.
namespace corpuscle::oracle {

struct StirredTank {
    struct Gas {
        double molar_mass, molar_cp;  ///< [kg/mol], [J/(mol K)]
        double mass;                  ///< [kg]
    };
    std::vector<Gas> gases;
    double energy = 0.0;  ///< [J]
    double volume = 0.0;  ///< [m^3]

    [[nodiscard]] double moles() const {
        double n = 0.0;
        for (const Gas& gas : gases) n += gas.mass / gas.molar_mass;
        return n;
    }
    [[nodiscard]] double heat_capacity(double less) const {  ///< of all, cp - less · R      [J/K]
        double sum = 0.0;
        for (const Gas& gas : gases)
            sum += gas.mass / gas.molar_mass * (gas.molar_cp - less * GAS_CONSTANT);
        return sum;
    }
    [[nodiscard]] double temperature() const { return energy / heat_capacity(1.0); }
    [[nodiscard]] double pressure() const {
        return moles() * GAS_CONSTANT * temperature() / volume;
    }
    [[nodiscard]] double mass() const {
        double m = 0.0;
        for (const Gas& gas : gases) m += gas.mass;
        return m;
    }

    /// Lets gas out for `time`: share(tank) is what leaves of each gas per time, with its enthalpy.
    ///     dm/dt = -share m,  dE/dt = -share H,   H = sum n cp T              (midpoint rule)
    void empty(double time, int steps, const std::function<double(const StirredTank&)>& share) {
        const double dt = time / steps;
        const auto moved = [](const StirredTank& from, const StirredTank& rates, double s,
                              double span) {
            StirredTank to = from;
            for (std::size_t g = 0; g < to.gases.size(); ++g)
                to.gases[g].mass -= span * s * rates.gases[g].mass;
            to.energy -= span * s * rates.heat_capacity(0.0) * rates.temperature();
            return to;
        };
        for (int i = 0; i < steps; ++i) {
            const StirredTank middle = moved(*this, *this, share(*this), 0.5 * dt);
            *this = moved(*this, middle, share(middle), dt);
        }
    }
};

/// Wang and Nefske's flow of a tank of one gas, written from the flow through a nozzle: density and
/// speed at the throat, at its pressure.                                               [kg/(m^2 s)]
inline double nozzle_flux(double p, double T, double molar_mass, double molar_cp, double outside) {
    if (p <= outside) return 0.0;
    const double gamma = molar_cp / (molar_cp - GAS_CONSTANT);
    const double sonic = p * std::pow(1.0 + 0.5 * (gamma - 1.0), -gamma / (gamma - 1.0));
    const double p_throat = std::max(outside, sonic);
    const double T_throat = T * std::pow(p_throat / p, (gamma - 1.0) / gamma);
    const double speed = std::sqrt(2.0 * molar_cp / molar_mass * (T - T_throat));
    return p_throat * molar_mass / (GAS_CONSTANT * T_throat) * speed;
}

}  // namespace corpuscle::oracle
