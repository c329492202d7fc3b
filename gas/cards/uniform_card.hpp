// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"

/// What *AIRBAG_SIMPLE_AIRBAG_MODEL and *AIRBAG_WANG_NEFSKE say of one bag, in deck units.
namespace corpuscle::gas {

/// A value, or a curve of something; the curve counts where it is given.
struct CurveOr {
    double value = 0.0;
    Index curve = -1;  ///< row in Model::curves
};

/// A hole: mass flow = coefficient · area · orifice_flow().
struct ExitCard {
    CurveOr coefficient{1.0};              ///< MU of pressure; C23, CP23 of time               [-]
    bool coefficient_of_pressure = false;  ///< else of time
    CurveOr area;  ///< AREA, A23, AP23, of absolute pressure           [m^2]
};

/// One bag of uniform pressure.
struct UniformBagCard {
    std::string keyword;  ///< for messages: "*AIRBAG_WANG_NEFSKE"
    int id = 0;
    std::string title;
    std::vector<Index> shells;    ///< shell rows that close the bag
    double volume_scale = 1.0;    ///< VSCA                                          [-]
    double pressure_scale = 1.0;  ///< PSCA                                          [-]
    double volume_taken = 0.0;    ///< VINI: V = VSCA · V of the mesh - VINI         [m^3]
    double cv = NaN, cp = NaN;    ///< CV, CP                                  [J/(kg K)]
    CurveOr temperature;          ///< T, LCT: of the gas that comes in, of time     [K]
    Index mass_rate = -1;         ///< LCID, LCMT: of time                        [kg/s]
    std::vector<ExitCard> exits;
    Index exit_rate = -1;       ///< LOU, LCEFR: mass flow out of gauge pressure [kg/s]
    double opens_at = 0.0;      ///< PPOP: gauge pressure from which exits are open [Pa]
    double p_atm = NaN;         ///< PE                                           [Pa]
    double density = NaN;       ///< RO: of the gas inside at the start      [kg/m^3]
    double overpressure = 0.0;  ///< POVER: gauge pressure at the start           [Pa]
};

}  // namespace corpuscle::gas
