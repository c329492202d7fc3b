// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <vector>

namespace corpuscle::oracle {

/// Gas at one place of a tube.
struct Gas1D {
    double density;   ///< [kg/m^3]
    double velocity;  ///< [m/s]
    double pressure;  ///< [Pa]
};

/// Ideal gas in a tube from x = 0, closed for good, to a piston that moves.
///
/// The 1-D Euler equations by finite volumes on a mesh that stretches with the piston (uniform
/// cells, faces move in proportion): linear reconstruction of (rho, u, p) with van Leer's slopes,
/// HLLC fluxes through moving faces [Toro, ch. 10], exact half-Riemann problems at both walls,
/// Heun's two stages. Second order where the flow is smooth. Mass is conserved to rounding, energy
/// but for the piston's work.
class EulerTube {
public:
    EulerTube(double gamma, double length, std::size_t cells,
              const std::function<Gas1D(double x)>& initial);

    /// Lets gas out through the side walls: share of what is at x that leaves in a time, with its
    /// enthalpy and its velocity.                                                         [1/s]
    ///     d(rho, rho u, E)/dt = -share (rho, rho u, E + p)
    void leak(const std::function<double(double x, const Gas1D&)>& share) { leak_ = share; }

    /// Goes on to time `until`; the piston's velocity is a function of time.            [s], [m/s]
    void advance(double until, const std::function<double(double t)>& piston_velocity);

    [[nodiscard]] double time() const { return time_; }
    [[nodiscard]] double length() const { return length_; }
    /// Of the gas at the piston's face, moving with it.                                       [Pa]
    [[nodiscard]] double piston_pressure() const;
    /// Cell averages as gas, in order from the closed end.
    [[nodiscard]] std::vector<Gas1D> gas() const;
    [[nodiscard]] double centre(std::size_t cell) const;
    [[nodiscard]] double mass() const;    ///< per area of the tube  [kg/m^2]
    [[nodiscard]] double energy() const;  ///< per area of the tube  [J/m^2]

private:
    using Conserved = std::array<double, 3>;  ///< mass, momentum, energy
    struct Faces {
        Gas1D left, right;  ///< of one cell, reconstructed at its two ends
    };

    [[nodiscard]] Gas1D gas(const Conserved& cell, double width) const;
    [[nodiscard]] std::vector<Faces> reconstruct(const std::vector<Conserved>& cells,
                                                 double length) const;
    [[nodiscard]] std::vector<Conserved> rate(const std::vector<Conserved>& cells, double length,
                                              double piston_velocity) const;
    void take_leak(const std::vector<Conserved>& cells, double length,
                   std::vector<Conserved>& rates) const;
    [[nodiscard]] Conserved flux(const Gas1D& left, const Gas1D& right, double face_velocity) const;
    [[nodiscard]] double wall_pressure(const Gas1D& gas, double receding) const;
    [[nodiscard]] double stable_step(double piston_velocity) const;

    double gamma_;
    double length_;
    double time_ = 0.0;
    double piston_velocity_ = 0.0;
    std::function<double(double, const Gas1D&)> leak_;  ///< none: the walls are tight
    std::vector<Conserved> cells_;  ///< totals of each cell, per area of the tube
};

}  // namespace corpuscle::oracle
