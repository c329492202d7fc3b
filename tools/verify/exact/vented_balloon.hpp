// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <functional>

#include "tools/verify/exact/stirred_tank.hpp"

/// A sphere of cloth whose gas is always mixed, filled and vented: ordinary differential equations.
///
///     dm/dt = in - out,   dU/dt = h(T_in) in - h(T) out - p dV/dt,   out = C23 A G(p, T)
///     rho h R l'' = (p - p_out) l² - (2 / R) h (D11 + D12) l (l² - 1) / 2,   r = l R
namespace corpuscle::oracle {

struct VentedBalloon {
    double radius;        ///< R, of the cloth without stress                            [m]
    double mass_by_area;  ///< rho h, of the cloth without stress                        [kg/m^2]
    double stiffness;     ///< h (D11 + D12) of sphere_stretch()                         [N/m]
    double vent;          ///< C23 times the vent's share of the sphere                  [-]
    double outside;       ///< p_out                                                     [Pa]
    double molar_mass, molar_cp;

    double mass = 0.0, energy = 0.0;      ///< of the gas                                [kg], [J]
    double stretch = 1.0, opening = 0.0;  ///< l, dl/dt                                  [-], [1/s]

    [[nodiscard]] double area() const { return 4.0 * PI * std::pow(stretch * radius, 2); }
    [[nodiscard]] double volume() const { return area() * stretch * radius / 3.0; }
    [[nodiscard]] double temperature() const {
        return energy * molar_mass / (mass * (molar_cp - GAS_CONSTANT));
    }
    [[nodiscard]] double pressure() const {
        return mass / molar_mass * GAS_CONSTANT * temperature() / volume();
    }

    /// From `from` to `to`, midpoint rule. @param inflow  mass a time at t, of static T_in
    void advance(double from, double to, int steps, const std::function<double(double)>& inflow,
                 double T_in) {
        const double dt = (to - from) / steps;
        for (int k = 0; k < steps; ++k) {
            const double t = from + k * dt;
            VentedBalloon middle = *this;
            middle.change(0.5 * dt, *this, inflow(t), T_in);
            change(dt, middle, inflow(t + 0.5 * dt), T_in);
        }
    }

private:
    static inline const double PI = std::acos(-1.0);

    void change(double dt, const VentedBalloon& at, double in, double T_in) {
        const double p = at.pressure(), T = at.temperature(), l = at.stretch;
        const double out = vent * at.area() * nozzle_flux(p, T, molar_mass, molar_cp, outside);
        const double pull = stiffness * l * (l * l - 1.0) / radius;
        mass += dt * (in - out);
        energy += dt * (molar_cp / molar_mass * (T_in * in - T * out) -
                        p * at.area() * radius * at.opening);
        stretch += dt * at.opening;
        opening += dt * ((p - outside) * l * l - pull) / (mass_by_area * radius);
    }
};

}  // namespace corpuscle::oracle
