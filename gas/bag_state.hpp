// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "gas/thermo/species.hpp"

namespace corpuscle::gas {

/// A snapshot of the gas in one bag.
struct GasState {
    double volume = 0, pressure = 0, temperature = 0, area = 0;
    double mass = 0, mass_in = 0;
    double mass_out_vent = 0, mass_out_fabric = 0, particles_out = 0;  ///< so far
    double energy = 0;         ///< all that the gas inside holds
    double translational = 0;  ///< of which makes pressure, p = 2/3 translational / volume
    struct Share {
        double mass = 0, temperature = 0, energy = 0;
    };
    std::vector<Share> species;  ///< initial air first, if any
};

/// The gas in one chamber of a bag.
struct ChamberState {
    double volume = 0, pressure = 0, temperature = 0, mass = 0, energy = 0;
};

/// A chamber's state while it is added up, room by room.
struct ChamberSum {
    ChamberState state;
    double pV = 0.0;           ///< [J]
    EnergyPolynomial content;  ///< energy of its gas at rest, as a polynomial in T
};

/// What the gas does to each part.
struct PartState {
    std::vector<double> pressure;  ///< absolute, mean since the last look   [Pa]
    std::vector<double> area;      ///< now                                  [m^2]
    std::vector<double> mass_out;  ///< so far                               [kg]
    std::vector<double> heat;      ///< lost to it so far                    [J]
};

}  // namespace corpuscle::gas
