// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gas/enclosure/wetted_surface.hpp"
#include "gas/flight/flight.hpp"
#include "gas/wall_load/point_smoother.hpp"

namespace corpuscle::gas {

/// Elastic impact of a particle of mass m on a free wall of light cloth.
///
/// Smoothing spreads a hit's impulse J over points q, each of which gets S_q of it
/// (point_smoother.hpp). Given at once, it brings the cloth |J|² / 2M where it was at rest, with
///
///     1 / M = sum S_q² / m_q,
///
/// so of what a wall of infinite mass would take of momentum and kinetic energy it takes
///
///     f = M / (M + m)
///
/// (J = f m (v - v'), from v' = -v in the frame of the centre of mass). Without recoil a heavy
/// particle on light cloth does work J²/2M without a source.
///
/// A particle that hits k times in a step flies between its hits as reflected by walls of infinite
/// mass. A hit then takes account of the particle's deviation from that velocity, d, and of the
/// velocity w = sum S_q w_q that the particle's earlier hits have given to the cloth at its place:
///
///     J' = f max(0, J·n + 2 m (d - w)·n) n,   d' = d + (J - J') / m,   w_q' = w_q + S_q J' / m_q,
///
/// n = J / |J|. All hits together take sum m_q w_q² / 2 where the cloth was at rest, the energy of
/// their impulses on it. max: a wall that the particle does not meet does not pull. The correction
/// acts at the end x of the flight, not at the hit y, so the wall also gets the moment
/// (y - x) × (J - J').
class Recoil {
public:
    /// @param held  by wall point: 1 where supports, motions or bodies carry it
    explicit Recoil(std::span<const std::uint8_t> held) : held_(held.begin(), held.end()) {}

    /// Takes over the masses of the points' nodes [kg].
    void set_points(std::size_t count) { mass_.resize(count); }
    void weigh(std::size_t point, double node_mass) { mass_[point] = node_mass; }

    /// Corrects the impulses of one particle's hits in one step, in their order, and its velocity v
    /// after them; energy m (v² - v'²) / 2 and both momenta are balanced to rounding.
    /// Nothing where m is below LIGHT of the mass of each of the sides' nodes, or before weigh().
    /// @param sides  of the hits
    /// @param x      where the particle is after them                                       [m]
    void set_right(const WettedSurface& surface, const PointSmoother& smoother, std::span<Hit> hits,
                   std::span<const Index> sides, double m, const Vec3& x, Vec3& v) const;

private:
    [[nodiscard]] bool is_heavy(double m, const std::array<Index, 3>& points) const;

    std::vector<std::uint8_t> held_;  ///< by point
    std::vector<double> mass_;        ///< of each point's node                        [kg]
};

}  // namespace corpuscle::gas
