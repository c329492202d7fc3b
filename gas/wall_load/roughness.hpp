// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/enclosure/wetted_surface.hpp"
#include "gas/flight/flight.hpp"
#include "gas/flight/rough_wall.hpp"
#include "gas/wall_load/wall_hits.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle::gas {

/// How rough each side of a bag's facets is: FRIC and PFRIC, as numbers or over the pressure on the
/// part there.
///
/// A part has a pressure in each room that it walls: what hits in that room bring to it along its
/// normal, averaged over `time`, and that of the room's initial air.
class Roughness {
public:
    /// @param surface  of these walls
    /// @param time     over which pressures are averaged                                  [s]
    Roughness(const BagCard& card, const BagWalls& walls,
              std::shared_ptr<const WettedSurface> surface, std::span<const Curve> curves,
              double time);

    [[nodiscard]] WallFriction now() const { return {0.0, pushes_along_, of_side_, closing_}; }
    /// Whether it goes with pressures.
    [[nodiscard]] bool follows_pressure() const { return !rough_.empty(); }

    /// Takes in a flight's hits.
    /// @param hits  of that flight, by their sides
    /// @param air   pressure that no particles bring, of each room                        [Pa]
    void receive(const FlightResult& flight, const WallHits& hits, double dt,
                 std::span<const double> air, std::span<const Vec3> x);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(of_side_);
        for (Rough& rough : rough_) archive(rough.pressure, rough.impulse, rough.area);
    }

private:
    /// A part in a room.
    struct Rough {
        Index part, room;  ///< part: a row of the bag's
        Curve over_pressure;
        double pressure = 0.0;  ///< of its hits, averaged                                 [Pa]
        double impulse = 0.0;   ///< of this step                                          [N s]
        double area = 0.0;      ///< now, of its sides in the room                         [m^2]
    };
    [[nodiscard]] Index row_of(Index part, Index room, const Curve& over_pressure);

    std::shared_ptr<const WettedSurface> surface_;
    std::vector<double> of_side_;  ///< empty: nothing is rough                             [-]
    bool pushes_along_;
    std::vector<Rough> rough_;     ///< whose friction goes with their pressure
    std::vector<Index> rough_of_;  ///< row in `rough_` of each side, or -1
    Index closing_;
    double time_;
};

}  // namespace corpuscle::gas
