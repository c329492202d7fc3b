// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// The gas in one chamber of a bag, or in one room.
struct ChamberState {
    double volume = 0;           ///< enclosed                                                 [m^3]
    double pressure = 0;         ///< absolute                                                  [Pa]
    double temperature = 0;      ///< at which the gas at rest would hold its energy            [K]
    double mass = 0;             ///< inside                                                    [kg]
    double energy = 0;           ///< all that the gas inside holds                             [J]
    double static_pressure = 0,  ///< without the motion of each room's gas as a whole  [Pa]
        static_temperature = 0;  ///< likewise  [K]
};

/// The gas of a bag at t.
struct GasState {
    double volume = 0;           ///< enclosed                                                 [m^3]
    double pressure = 0;         ///< absolute                                                  [Pa]
    double temperature = 0;      ///< at which the gas at rest would hold its energy             [K]
    double area = 0;             ///< of what closes the bag                                   [m^2]
    double mass = 0;             ///< inside                                                    [kg]
    double mass_in = 0;          ///< come in, so far                                           [kg]
    double mass_out_vent = 0,    ///< through vents, so far  [kg]
        mass_out_fabric = 0;     ///< through fabric that leaks, so far  [kg]
    double particles_out = 0;    ///< particles gone, so far                                     [-]
    double energy = 0;           ///< all that the gas inside holds                            [J]
    double translational = 0;    ///< of which makes pressure, p = 2/3 translational / volume  [J]
    double static_pressure = 0,  ///< without the motion of each room's gas as a whole  [Pa]
        static_temperature = 0;  ///< likewise  [K]
    /// One gas of it.
    struct Share {
        double mass = 0;         ///< inside  [kg]
        double temperature = 0;  ///< at which it would hold its energy at rest  [K]
        double energy = 0;       ///< that it holds  [J]
    };
    std::vector<Share> species;  ///< initial air first, if any

    /// As of a bag that is one chamber.
    [[nodiscard]] ChamberState as_chamber() const {
        return {volume, pressure, temperature, mass, energy, static_pressure, static_temperature};
    }
};

/// A chamber's state while it is added up, room by room.
struct ChamberSum {
    ChamberState state;        ///< as far as it is added up
    double pV = 0.0;           ///< sum of the rooms' pressure times volume                  [J]
    double bulk = 0.0;         ///< of the energy: that of its rooms' gas as a whole         [J]
    EnergyPolynomial content;  ///< energy of its gas at rest, as a polynomial in T

    /// What it comes to, once all rooms are added.
    [[nodiscard]] ChamberState whole() const {
        ChamberState all = state;
        all.pressure = pV / all.volume;
        all.static_pressure = std::max(0.0, pV - 2.0 / 3.0 * bulk) / all.volume;
        if (!(all.mass > 0.0)) return all;
        all.temperature = content.temperature(all.energy);
        all.static_temperature = content.temperature(std::max(0.0, all.energy - bulk));
        return all;
    }
};

/// Load on shells while it is added up, bag by bag: on a shell of two bags the difference of what
/// both do.
struct ShellLoad {
    /// Of no bag as yet.
    explicit ShellLoad(std::size_t shells) : force(shells, 0.0), facing(shells, 0) {}

    /// Sign with which a bag's outward load on a triangle of a shell counts.
    /// @param is_turned  outward is against the order of the shell's nodes
    [[nodiscard]] double sign(Index shell, bool is_turned) {
        const std::int8_t own = is_turned ? -1 : 1;
        if (facing[shell] == 0) facing[shell] = own;
        return own == facing[shell] ? 1.0 : -1.0;
    }

    std::vector<double> force;        ///< E: outward of the first bag that has the shell      [N]
    std::vector<std::int8_t> facing;  ///< E: that way along the order of nodes, 0: of no bag
};

/// What the gas did to each part of a bag, in the order of BagWalls::part_rows.
struct PartState {
    std::vector<double> pressure;  ///< absolute, mean since the last look   [Pa]
    std::vector<double> area;      ///< now                                  [m^2]
    std::vector<double> mass_out;  ///< gone through it, so far                [kg]
    std::vector<double> heat;      ///< lost to it so far                    [J]
};

}  // namespace corpuscle::gas
