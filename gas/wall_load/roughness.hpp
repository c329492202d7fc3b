// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/enclosure/bag_walls.hpp"
#include "gas/flight/flight.hpp"
#include "gas/flight/rough_wall.hpp"
#include "solver/base/curve.hpp"

namespace corpuscle::gas {

/// How rough each facet of a bag is: FRIC and PFRIC, as numbers or over the part's pressure.
///
/// A part's pressure is what hits bring to it along its normal, averaged over `time`, and that of
/// initial air.
class Roughness {
public:
    /// @param time  over which pressures are averaged                                     [s]
    Roughness(const BagCard& card, const BagWalls& walls, std::span<const Curve> curves,
              double time);

    [[nodiscard]] WallFriction now() const { return {0.0, pushes_along_, of_facet_}; }

    /// Takes in a flight's hits.
    /// @param air  pressure that no particles bring                                      [Pa]
    void receive(const FlightResult& flight, double dt, double air, std::span<const Vec3> x);

    /// What a checkpoint holds of it (solver/base/archive.hpp).
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(of_facet_);
        for (Rough& rough : rough_) archive(rough.pressure, rough.impulse, rough.area);
    }

private:
    struct Rough {
        Index part;  ///< row of the bag's parts
        Curve over_pressure;
        double pressure = 0.0;  ///< of its hits, averaged                                 [Pa]
        double impulse = 0.0;   ///< of this step                                          [N s]
        double area = 0.0;      ///< now                                                   [m^2]
    };
    std::vector<double> of_facet_;  ///< empty: nothing is rough                            [-]
    bool pushes_along_;
    std::vector<Rough> rough_;     ///< parts whose friction goes with their pressure
    std::vector<Index> rough_of_;  ///< row in `rough_` of each part, or -1
    std::vector<Triangle> triangles_;
    std::vector<Index> part_;
    double time_;
};

}  // namespace corpuscle::gas
