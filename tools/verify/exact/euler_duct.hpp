// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <vector>

#include "tools/verify/exact/euler_1d.hpp"

namespace corpuscle::oracle {

/// What enters a duct at its closed end, per time and area of the duct.
struct DuctInflow {
    double mass;      ///< [kg/(m^2 s)]
    double momentum;  ///< along the duct [Pa]
    double energy;    ///< [W/m^2]
};

/// Ideal gas in a duct from x = 0, closed but for what enters there, to an opening over the whole
/// end at `length`, with gas at rest at p_out outside that never comes in.
///
/// The 1-D Euler equations by finite volumes: linear reconstruction of (rho, u, p) with van Leer's
/// slopes, exact Riemann fluxes [Toro, ch. 4], Heun's two stages. Inflow is a source within
/// `source_length` of the closed end. The opening is a nozzle as wide as the duct: Wang and
/// Nefske's flow of the stagnation state that arrives, along the characteristic that leaves the
/// duct:
///     u + 2 c / (gamma - 1) and p / rho^gamma are those inside,
///     p = p_out if that is subsonic, else u = c;   supersonic: the state inside;   u < 0: closed.
class EulerDuct {
public:
    EulerDuct(double gamma, double length, std::size_t cells, const Gas1D& initial, double p_out,
              double source_length);

    /// Goes on to time `until` with constant inflow.
    void advance(double until, const DuctInflow& inflow);

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double mass_out() const { return out_[0]; }    ///< so far [kg/m^2]
    [[nodiscard]] double energy_out() const { return out_[2]; }  ///< so far [J/m^2]
    [[nodiscard]] double mass() const { return total(0); }       ///< inside [kg/m^2]
    [[nodiscard]] double energy() const { return total(2); }     ///< inside [J/m^2]
    [[nodiscard]] std::vector<Gas1D> gas() const;

private:
    using Conserved = std::array<double, 3>;  ///< mass, momentum, energy

    [[nodiscard]] Gas1D primitive(const Conserved& cell) const;
    [[nodiscard]] Conserved flux_of(const Gas1D& gas) const;
    [[nodiscard]] Gas1D at_opening(const Gas1D& inside) const;
    /// Rates of the cells [per volume], then what flows out [per area].
    [[nodiscard]] std::vector<Conserved> rates(const std::vector<Conserved>& cells,
                                               const DuctInflow& inflow) const;
    [[nodiscard]] double total(int k) const;

    double gamma_, width_, p_out_;
    std::size_t source_cells_;
    double time_ = 0.0;
    std::vector<Conserved> cells_;  ///< per volume
    Conserved out_{};
};

}  // namespace corpuscle::oracle
