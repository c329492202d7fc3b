// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gas/enclosure/wetted_surface.hpp"

namespace corpuscle::gas {

/// What is smoothed, per area of a wall point.
struct Brought {
    double push = 0.0;           ///< normal impulse of hits                         [N s/m^2]
    double mass = 0.0;           ///< of the particles that hit                      [kg/m^2]
    Vec3 beside = Vec3::Zero();  ///< impulse of hits that is not along the normal   [N s/m^2]
};

/// What of an impulse at one place each point gets; keeps its memory from one place to the next.
class PlaceSpread {
public:
    /// Points that get a share, each once.
    [[nodiscard]] std::span<const Index> points() const { return points_; }
    /// Of points() alone.                                                                     [-]
    [[nodiscard]] double share(Index point) const { return share_[point]; }

    /// Begins anew, on a surface of so many points.
    void begin(std::size_t count) {
        reached_.resize(std::max(reached_.size(), count), 0);
        share_.resize(reached_.size(), 0.0);
        ++place_;
        points_.clear();
    }
    /// Adds to a point's share.
    void add(Index point, double share) {
        if (reached_[point] != place_) {
            reached_[point] = place_;
            points_.push_back(point);
            share_[point] = 0.0;
        }
        share_[point] += share;
    }

private:
    std::vector<Index> points_;
    std::vector<double> share_;           ///< by point
    std::vector<std::uint64_t> reached_;  ///< by point: the place that reached it last
    std::uint64_t place_ = 0;
};

/// Conservative smoothing along the wetted surface: PASSES times
///
///     u_p += 1/A_p sum_q k_pq (u_q - u_p),   k_pq = k_qp = min(A_p, A_q) gate_pq / (1 + n)
///
/// u: per area, A: area of a wall point, n: the larger number of neighbours of the two. sum A u
/// stays (up to rounding), an even u stays as it is. A gate is open (1) between points that gas has
/// reached on cloth that is smooth there, and shut (0) at the edge of the gas, at a fold, at nodes
/// that supports or bodies carry, and, as the wetted surface has no edge there, at membranes.
class PointSmoother {
public:
    explicit PointSmoother(const WettedSurface& surface);

    /// Transmission and weights for one step.
    /// @param area  points × 3, out of the gas                                        [m^2]
    /// @param size  its norm                                                          [m^2]
    /// @param takes_part  points: 0 where nothing is to be spread
    void prepare(const WettedSurface& surface, std::span<const Vec3> area,
                 std::span<const double> size, std::span<const std::uint8_t> takes_part);
    void spread(const WettedSurface& surface, std::vector<Brought>& field);
    /// What spread() makes of an impulse at one place, as prepare() has left its weights: takes its
    /// shares from points that it begins with to those that get them.
    void spread(const WettedSurface& surface, PlaceSpread& impulse) const;

    /// What a pass takes of the unevenness of a field of impulses: sum over neighbours q of
    /// k (u_q - u_p)², u per area. After prepare().                                   [N^2 s^2/m^2]
    [[nodiscard]] double unevenness(const WettedSurface& surface, std::size_t p,
                                    std::span<const double> impulse) const;

private:
    std::vector<double> share_;  ///< of each edge: 1 / (1 + n)
    std::vector<double> link_;   ///< k of each edge                                    [m^2]
    std::vector<double> per_area_;
    std::vector<Brought> next_;
};

}  // namespace corpuscle::gas
