// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// The gas of a bag at t.
struct GasState {
    double volume = 0;         ///< enclosed                                                 [m^3]
    double pressure = 0;       ///< absolute                                                  [Pa]
    double temperature = 0;    ///< at which the gas at rest would hold its energy             [K]
    double area = 0;           ///< of what closes the bag                                   [m^2]
    double mass = 0;           ///< inside                                                    [kg]
    double mass_in = 0;        ///< come in, so far                                           [kg]
    double mass_out_vent = 0,  ///< through vents, so far  [kg]
        mass_out_fabric = 0;   ///< through fabric that leaks, so far  [kg]
    double particles_out = 0;  ///< particles gone, so far                                     [-]
    double energy = 0;         ///< all that the gas inside holds                            [J]
    double translational = 0;  ///< of which makes pressure, p = 2/3 translational / volume  [J]
    /// One gas of it.
    struct Share {
        double mass = 0;         ///< inside  [kg]
        double temperature = 0;  ///< at which it would hold its energy at rest  [K]
        double energy = 0;       ///< that it holds  [J]
    };
    std::vector<Share> species;  ///< initial air first, if any
};

/// The gas in one chamber of a bag.
struct ChamberState {
    double volume = 0;       ///< enclosed                                                 [m^3]
    double pressure = 0;     ///< absolute                                                  [Pa]
    double temperature = 0;  ///< at which the gas at rest would hold its energy            [K]
    double mass = 0;         ///< inside                                                    [kg]
    double energy = 0;       ///< all that the gas inside holds                             [J]
};

/// A chamber's state while it is added up, room by room.
struct ChamberSum {
    ChamberState state;        ///< as far as it is added up
    double pV = 0.0;           ///< sum of the rooms' pressure times volume                  [J]
    EnergyPolynomial content;  ///< energy of its gas at rest, as a polynomial in T
};

/// What the gas did to each part of a bag, in the order of BagWalls::part_rows.
struct PartState {
    std::vector<double> pressure;  ///< absolute, mean since the last look   [Pa]
    std::vector<double> area;      ///< now                                  [m^2]
    std::vector<double> mass_out;  ///< gone through it, so far                [kg]
    std::vector<double> heat;      ///< lost to it so far                    [J]
};

}  // namespace corpuscle::gas
