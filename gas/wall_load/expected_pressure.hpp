// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/enclosure/enclosure.hpp"

namespace corpuscle::gas {

/// The pressure that hits make one expect at each node of a bag's surface: their normal force,
/// averaged over `time` and over neighbours on the cloth.
///
///     p_n = (W R)_n / (W |A|)_n,   R' = (j·A/|A| / span - R) / time
///
/// j: impulse that has come to the node, A: its vector area. W: PASSES times the mean of a node and
/// its neighbours, in effect over some 130 facets, so that a pressure as even as a gas makes it is
/// known far better than from a node's own hits.
class ExpectedPressure {
public:
    ExpectedPressure(std::size_t node_count, const Enclosure& enclosure, double time);

    /// Takes in the impulses that came during `span`.  arrived, area: N × 3 [N s], [m^2]
    void update(double span, std::span<const Vec3> arrived, std::span<const Vec3> area);

    /// A node that leaves its neighbours at w feels (1 - share_per_speed w) of the pressure that
    /// update() finds next: with 1 / sqrt(R T / M) that is p - rho sqrt(R T / M) w, what a sound
    /// wave carries away, which the average over time and neighbours leaves out (VNDAMP).
    ///
    ///     w_n = v_n - (W v A)_n / (W A)_n,   v_n = (x_1 - x_0)·A / (|A| dt)
    void feel_motion(std::span<const Vec3> x_0, std::span<const Vec3> x_1, double dt,
                     std::span<const Vec3> area, double share_per_speed);

    /// Pressure at the i-th of the enclosure's nodes.                                         [Pa]
    [[nodiscard]] double operator[](std::size_t i) const { return pressure_[i]; }

    /// As if `pressure` had long been there.
    void begin_with(double pressure, std::span<const Vec3> area);
    /// Expects nothing from now on.
    void stop() { force_.clear(); }
    [[nodiscard]] bool is_on() const { return !force_.empty(); }

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(force_, pressure_, less_);
    }

private:
    struct ForceAndArea {
        double force = 0.0, area = 0.0;
    };
    void spread();

    std::vector<Index> nodes_;                ///< rows, of the enclosure
    std::vector<Index> start_, neighbour_;    ///< places in nodes_, compressed rows
    double time_;                             ///< [s]
    std::vector<double> force_;               ///< R                                           [N]
    std::vector<double> pressure_;            ///< [Pa]
    std::vector<double> less_;                ///< share of it that motion takes; empty: none
    std::vector<ForceAndArea> field_, next_;  ///< what is spread
};

}  // namespace corpuscle::gas
