// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>

#include "solver/base/constants.hpp"

/// Two rooms of gases that effuse into each other through small holes, both always mixed: ordinary
/// differential equations.
///
///     out of a room, of each gas:   n' = -A n / V sqrt(R T / (2 pi M)),   E' = ((cp - R) T + R T / 2) n'
namespace corpuscle::oracle {

struct GrahamRooms {
    struct Gas {
        double molar_mass, molar_cp;
    };
    struct Room {
        std::array<double, 2> moles{};
        double energy = 0.0;
    };
    std::array<Gas, 2> gases;
    std::array<Room, 2> rooms;
    double volume;  ///< of each                                                         [m^3]
    double holes;   ///< A                                                               [m^2]

    [[nodiscard]] double temperature(const Room& room) const {
        double capacity = 0.0;
        for (std::size_t g = 0; g < 2; ++g)
            capacity += room.moles[g] * (gases[g].molar_cp - GAS_CONSTANT);
        return room.energy / capacity;
    }
    [[nodiscard]] double pressure(const Room& room) const {
        return (room.moles[0] + room.moles[1]) * GAS_CONSTANT * temperature(room) / volume;
    }

    /// Midpoint rule.
    void advance(double time, int steps) {
        const double dt = time / steps;
        for (int k = 0; k < steps; ++k) {
            GrahamRooms middle = *this;
            middle.exchange(0.5 * dt, rooms);
            exchange(dt, middle.rooms);
        }
    }

private:
    void exchange(double dt, const std::array<Room, 2>& at) {
        const double pi = std::acos(-1.0);
        for (std::size_t r = 0; r < 2; ++r) {
            const double T = temperature(at[r]);
            for (std::size_t g = 0; g < 2; ++g) {
                const double speed = std::sqrt(GAS_CONSTANT * T / (2.0 * pi * gases[g].molar_mass));
                const double n = dt * holes * at[r].moles[g] / volume * speed;
                const double E = n * (gases[g].molar_cp - 0.5 * GAS_CONSTANT) * T;
                rooms[r].moles[g] -= n;
                rooms[1 - r].moles[g] += n;
                rooms[r].energy -= E;
                rooms[1 - r].energy += E;
            }
        }
    }
};

}  // namespace corpuscle::oracle
