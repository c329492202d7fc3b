// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

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

/// Where the particles of some bags are, by runs of rows, which lie near one another: sensors look
/// into runs that they may meet. Holds until particles move.
class ParticleRuns {
public:
    static constexpr std::size_t ROWS = 128;  ///< of a run; the last of a bag may have fewer

    /// Boxes about the particles of bags where they are now.
    explicit ParticleRuns(std::span<const BagGas> bags);
    /// visit(row) for the particles of a bag, by its row, in runs with a place as near to `at` as
    /// `reach`, ascending.
    template <class Visit>
    void for_each_near(std::size_t bag, const Vec3& at, double reach, Visit&& visit) const {
        for (const Run& run : runs_[bag]) {
            const Vec3 apart =
                (run.low - at).cwiseMax(at - run.high).cwiseMax(0.0);  // of the run's box
            if (apart.squaredNorm() > reach * reach) continue;
            for (std::size_t i = run.begin; i < run.end; ++i) visit(i);
        }
    }

private:
    struct Run {
        std::size_t begin, end;  ///< rows
        Vec3 low, high;          ///< [m]
    };
    std::vector<std::vector<Run>> runs_;  ///< by bag
};

/// Sums over all particles inside, whatever part of the sensor lies in the bag:
///
///     U = sum m v / sum m,   p = sum m (v - U)² / (3 V) N/(N - 1),   3/2 R n T = p V
///
/// In bags that have gone over to uniform pressure: what the room holds that the sensor's centre
/// lies in. Cost: a box for each run of particles, a distance for each particle of the runs that the
/// sensor may meet.
SensorReading read(const SensorCard& sensor, std::span<const BagGas> bags, const ParticleRuns& runs,
                   const Points& x);

}  // namespace corpuscle::gas
