// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <span>

#include "solver/base/vec.hpp"

namespace corpuscle::gas {

class BagGas;

/// A region of gas beside one segment, *DATABASE_CPM_SENSOR: it moves with it.
struct SensorCard {
    /// Of the region; CYLINDER and BOX stand along the segment's normal.
    enum class Shape { SPHERE, CYLINDER, BOX };

    Shape shape = Shape::SPHERE;   ///< gives `size` its meaning
    std::array<Index, 4> nodes{};  ///< of the segment; a triangle repeats its 3rd
    double offset = 0.0;  ///< OFFSET: of its centre from the segment's, along the normal  [m]
    /// Radius; radius and length along the normal; or lengths along nodes 1-2, along the third
    /// axis and along the normal.                                                             [m]
    std::array<double, 3> size{};
};

/// What the particles in a sensor are like at one instant.
struct SensorReading {
    double particles = 0;  ///< how many are inside, a whole number
    double pressure = 0;   ///< of their motion about their mean, and of initial air; absolute  [Pa]
    double temperature = 0;  ///< of that motion; 0 for fewer than two particles               [K]
    double density = 0;      ///< particles' mass over the sensor's volume                [kg/m^3]
    Vec3 velocity = Vec3::Zero();  ///< mean by mass                                         [m/s]
    Vec3 centre = Vec3::Zero();    ///< of the sensor                                        [m]
};

/// Sums over all particles inside, whatever part of the sensor lies in the bag:
///
///     U = sum m v / sum m,   p = sum m (v - U)² / (3 V) N/(N - 1),   3/2 R n T = p V
///
/// In bags that have gone over to uniform pressure: what the bag holds, where the sensor's centre
/// lies in it. Cost: one distance a particle.
SensorReading read(const SensorCard& sensor, std::span<const BagGas> bags, const Points& x);

}  // namespace corpuscle::gas
