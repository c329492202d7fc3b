// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/outflow/gas_state.hpp"
#include "gas/outflow/wall_samples.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle::gas {

/// Heat that the gas of a bag loses to its fabric (HCONV), patch by patch of the wall.
///
///     Q' = h A (T - T_atm)                                   [Newton's law of cooling]
///
/// T: of the gas at the patch, on its own side.
class HeatLoss {
public:
    HeatLoss(const BagCard& card, const BagWalls& walls, const WettedSurface& surface,
             const WallSamples& samples, std::span<const Curve> curves);

    [[nodiscard]] bool empty() const { return cooled_.empty(); }

    /// Heat that each patch takes from t to t + dt, none where gas has not come; so little that a
    /// room's gas of heat capacity C that nothing else warms comes to T_atm as
    /// exp(-t sum of h A / C).
    struct Taken {
        Index sample, room;
        double heat;  ///< [J]
    };
    const std::vector<Taken>& lose(double t, double dt, const WallSamples& samples,
                                   std::span<const Inside> rooms);

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
        Index sample, room;
    };
    std::vector<Cooled> cooled_;
    std::vector<Taken> taken_;
    std::vector<double> per_room_;  ///< sum of h A                                   [W/K]
    std::vector<double> part_heat_;
    double T_atm_;
    Inside local_;
};

}  // namespace corpuscle::gas
