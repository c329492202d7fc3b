// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/sensor.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gas/bag_gas.hpp"
#include "gas/enclosure/enclosure.hpp"
#include "gas/particles.hpp"
#include "solver/base/parallel.hpp"

namespace corpuscle::gas {
namespace {

/// The sensor where it is now.
struct Region {
    SensorCard::Shape shape;
    std::array<double, 3> size;
    Vec3 centre;
    Mat3 axes;  ///< rows: along nodes 1-2, the third axis, the normal

    [[nodiscard]] bool holds(const Vec3& point) const {
        const Vec3 from = point - centre;
        if (shape == SensorCard::Shape::SPHERE) return from.squaredNorm() <= size[0] * size[0];
        const Vec3 at = axes * from;
        if (shape == SensorCard::Shape::CYLINDER)
            return at.head<2>().squaredNorm() <= size[0] * size[0] &&
                   2.0 * std::abs(at[2]) <= size[1];
        return 2.0 * std::abs(at[0]) <= size[0] && 2.0 * std::abs(at[1]) <= size[1] &&
               2.0 * std::abs(at[2]) <= size[2];
    }
    /// Radius of a sphere about the centre that holds it, rounded up.                         [m]
    [[nodiscard]] double reach() const {
        constexpr double ROUNDING = 1e-9;
        const double radius = shape == SensorCard::Shape::SPHERE ? size[0]
                              : shape == SensorCard::Shape::CYLINDER
                                  ? std::hypot(size[0], 0.5 * size[1])
                                  : 0.5 * std::hypot(size[0], size[1], size[2]);
        return (1.0 + ROUNDING) * radius;
    }
    [[nodiscard]] double volume() const {
        using std::numbers::pi;
        switch (shape) {
            case SensorCard::Shape::SPHERE:
                return 4.0 / 3.0 * pi * size[0] * size[0] * size[0];
            case SensorCard::Shape::CYLINDER:
                return pi * size[0] * size[0] * size[1];
            case SensorCard::Shape::BOX:
                break;
        }
        return size[0] * size[1] * size[2];
    }
};

Region region(const SensorCard& card, const Points& x) {
    const auto& [a, b, c, d] = card.nodes;
    const bool is_triangle = c == d;
    const Vec3 middle =
        is_triangle ? Vec3((x[a] + x[b] + x[c]) / 3.0) : Vec3((x[a] + x[b] + x[c] + x[d]) / 4.0);
    const Vec3 normal = (x[c] - x[a]).cross((is_triangle ? x[c] : x[d]) - x[b]).normalized();
    const Vec3 along = (x[b] - x[a] - (x[b] - x[a]).dot(normal) * normal).normalized();
    Mat3 axes;
    axes.row(0) = along;
    axes.row(1) = normal.cross(along);
    axes.row(2) = normal;
    return {card.shape, card.size, middle + card.offset * normal, axes};
}

/// Sums over the particles of one region.
struct Sums {
    double particles = 0, moles = 0, mass = 0, square = 0;  ///< square: sum of m v²
    Vec3 momentum = Vec3::Zero();
};

void add(const BagGas& bag, std::size_t row, const ParticleRuns& runs, const Region& where,
         Sums& sums) {
    const Particles& gas = bag.particles();
    runs.for_each_near(row, where.centre, where.reach(), [&](std::size_t i) {
        if (!where.holds(gas.x[i])) return;
        const double m = bag.particle_mass()[gas.species[i]];
        sums.particles += 1.0;
        sums.moles += bag.moles_each();
        sums.mass += m;
        sums.momentum += m * gas.v[i];
        sums.square += m * gas.v[i].squaredNorm();
    });
}

/// All of a room is the same: what it holds, if the region's centre lies in it.
bool read_uniform(const BagGas& bag, std::size_t row, const ParticleRuns& runs, const Region& where,
                  const Points& x, SensorReading& reading) {
    if (!bag.enclosure().contains(where.centre, x)) return false;
    runs.for_each_near(row, where.centre, where.reach(), [&](std::size_t i) {
        reading.particles += where.holds(bag.particles().x[i]);
    });
    const ChamberState room = bag.room_state(where.centre, x);
    reading.pressure = room.pressure;
    reading.temperature = room.temperature;
    reading.density = room.mass / room.volume;
    return true;
}

}  // namespace

ParticleRuns::ParticleRuns(std::span<const BagGas> bags) : runs_(bags.size()) {
    for (std::size_t b = 0; b < bags.size(); ++b) {
        const Points& x = bags[b].particles().x;
        runs_[b].resize(parallel::chunk_count(x.size(), ROWS));
        parallel::for_each(
            runs_[b].size(),
            [&](std::size_t r) {
                const std::size_t begin = r * ROWS, end = std::min(x.size(), begin + ROWS);
                Run& run = runs_[b][r] = {begin, end, x[begin], x[begin]};
                for (std::size_t i = begin; i < end; ++i) {
                    run.low = run.low.cwiseMin(x[i]);
                    run.high = run.high.cwiseMax(x[i]);
                }
            },
            /*chunk=*/16);
    }
}

SensorReading read(const SensorCard& sensor, std::span<const BagGas> bags, const ParticleRuns& runs,
                   const Points& x) {
    const Region where = region(sensor, x);
    SensorReading reading;
    reading.centre = where.centre;
    Sums sums;
    double R = 0.0;
    for (std::size_t b = 0; b < bags.size(); ++b) {
        const BagGas& bag = bags[b];
        if (bag.is_uniform()) {
            if (read_uniform(bag, b, runs, where, x, reading)) return reading;
            continue;
        }
        add(bag, b, runs, where, sums);
        R = bag.card().gas_constant;
        if (bag.card().air && bag.enclosure().contains(where.centre, x))
            reading.pressure += bag.initial_air_pressure(where.centre, x);
    }
    reading.particles = sums.particles;
    if (sums.particles == 0.0) return reading;
    reading.velocity = sums.momentum / sums.mass;
    reading.density = sums.mass / where.volume();
    if (sums.particles < 2.0) return reading;
    const double about_mean =
        std::max(0.0, sums.square - sums.momentum.squaredNorm() / sums.mass);  // rounding
    const double three_pV = about_mean * sums.particles / (sums.particles - 1.0);
    reading.pressure += three_pV / (3.0 * where.volume());
    reading.temperature = three_pV / (3.0 * R * sums.moles);
    return reading;
}

}  // namespace corpuscle::gas
