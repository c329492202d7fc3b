// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/outflow/openings.hpp"

namespace corpuscle::gas {

/// Heat that the gas of a bag loses to its fabric (HCONV).
///
///     Q' = h A (T - T_atm)                                   [Newton's law of cooling]
class HeatLoss {
public:
    HeatLoss(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves);

    [[nodiscard]] bool empty() const { return cooled_.empty(); }

    /// Heat lost from t to t + dt by a gas of heat capacity C that nothing else warms:
    ///     Q = C (T - T_atm) (1 - exp(-dt sum of h A / C)),
    /// booked to parts by h A.                                                          [J]
    double lose(double t, double dt, std::span<const Vec3> x, const Inside& inside);

    [[nodiscard]] std::span<const double> part_heat() const { return part_heat_; }  ///< so far [J]

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(part_heat_);
    }

private:
    struct Cooled {
        double coefficient;  ///< [W/(m^2 K)]
        Curve over_time;     ///< in its place, if any
        Index part;          ///< row of the bag's parts
        std::vector<Index> facets;
        double power_per_kelvin;  ///< h A, of this step                               [W/K]
    };
    std::vector<Cooled> cooled_;
    std::vector<Triangle> triangles_;
    std::vector<double> part_heat_;
    double T_atm_;
};

}  // namespace corpuscle::gas
