// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/enclosure.hpp"

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

    /// Pressure at the i-th of the enclosure's nodes.                                         [Pa]
    [[nodiscard]] double operator[](std::size_t i) const { return pressure_[i]; }

    /// As if `pressure` had long been there.
    void begin_with(double pressure, std::span<const Vec3> area);
    /// Expects nothing from now on.
    void stop() { force_.clear(); }
    [[nodiscard]] bool is_on() const { return !force_.empty(); }

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
    std::vector<ForceAndArea> field_, next_;  ///< what is spread
};

}  // namespace corpuscle::gas
