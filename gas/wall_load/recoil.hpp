// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gas/enclosure/wetted_surface.hpp"
#include "gas/flight/flight.hpp"

namespace corpuscle::gas {

/// Elastic impact of a particle on a free wall of finite mass M: of what a wall of infinite mass
/// would take, momentum and kinetic energy leave
///
///     f = M / (M + m)
///
/// (J = f m (v - v'), from v' = -v in the frame of the centre of mass). M: mass of the cloth that
/// bears the hit at once, which is the cloth that smoothing spreads it over (point_smoother.hpp):
/// RINGS rings of points round the facet, as far as gas has reached. Without recoil a heavy
/// particle on light cloth gives work J²/2M that nobody pays.
///
/// A particle that hits k times in a step flies between its hits as walls of infinite mass have
/// thrown it. What it lacks of that velocity, d, is mirrored at the next hit as it is:
///
///     J' = f max(0, J·n + 2 m d·n) n,   d' = d + (J - J') / m,   n = J / |J|
///
/// so that walls at rest never make a particle faster; max: a wall that it does not meet does not
/// pull. The particle has flown on from each hit at y to x with what it is given at x, so the wall
/// also gets the moment (y - x) × (J - J').
class Recoil {
public:
    /// @param held  by wall point: 1 where supports, motions or bodies carry it
    explicit Recoil(std::span<const std::uint8_t> held) : held_(held.begin(), held.end()) {}

    /// Takes over the masses of the points' nodes [kg].
    void set_points(std::size_t count) { mass_.resize(count); }
    void weigh(std::size_t point, double node_mass) { mass_[point] = node_mass; }

    /// f of a particle of mass m [kg] that hits a side at barycentric coordinates `at`; 1 where m is
    /// below LIGHT of what each of the side's nodes weighs, or before weigh().
    /// @param link  by edge: 0 where the smoother is shut
    [[nodiscard]] double share(const WettedSurface& surface, std::size_t side,
                               const std::array<double, 3>& at, double m,
                               std::span<const double> link) const;

    /// Sets right what one particle's hits in one step gave, in their order, and its velocity v
    /// after them; energy m (v² - v'²) / 2 and both momenta stay booked to rounding.
    /// @param sides  of the hits
    /// @param x      where the particle is after them                                       [m]
    void set_right(const WettedSurface& surface, std::span<Hit> hits, std::span<const Index> sides,
                   double m, std::span<const double> link, const Vec3& x, Vec3& v) const;

private:
    [[nodiscard]] double mass_around(const WettedSurface& surface, std::size_t side,
                                     std::span<const double> link) const;

    std::vector<std::uint8_t> held_;  ///< by point
    std::vector<double> mass_;        ///< of each point's node                        [kg]
};

}  // namespace corpuscle::gas
