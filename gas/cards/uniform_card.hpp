// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gas/cards/bag.hpp"
#include "gas/cards/leak_law.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"

/// @file
/// What *AIRBAG_SIMPLE_AIRBAG_MODEL, *AIRBAG_WANG_NEFSKE and their like say, in deck units.

namespace corpuscle::gas {

/// A value, or a curve of something; the curve counts where it is given.
struct CurveOr {
    double value = 0.0;  ///< where `curve` is -1, in the units of what it stands for
    Index curve = -1;    ///< row in Model::curves
};

/// A hole: mass flow = coefficient · area · orifice_flow().
struct ExitCard {
    CurveOr coefficient{1.0};              ///< MU of pressure; C23, CP23 of time               [-]
    bool coefficient_of_pressure = false;  ///< else of time
    CurveOr area;  ///< AREA, A23, AP23, of absolute pressure           [m^2]
    /// A23 < 0: shells of a part, whose area counts as it is at the time; a triangle repeats its
    /// third node. None: `area`.
    std::vector<std::array<Index, 4>> facets;
};

/// Fabric of one part that leaks: FLC, FAC, X0-X3, FVOPT.
struct UniformLeak {
    Index part = -1;  ///< part row
    CurveOr share;    ///< FLC, of time                                                   [-]
    CurveOr factor;   ///< FAC, of absolute pressure           [m/s], [-] or [s/m], by law
    LeakLaw law = LeakLaw::VELOCITY;  ///< what `factor` is, by FVOPT
    /// X0-X3: Wang-Nefske flow through A0 (X0 + X1 rs + X2 rp + X3 rs rp), instead of these.
    std::optional<std::array<double, 4>> growth;
};

/// One of several gases of *AIRBAG_HYBRID.
struct UniformGasCard {
    SpeciesCard species;       ///< MW, A, B, C
    double start_share = 0.0;  ///< INITM: of the mass inside at the start                   [-]
    Index mass_rate = -1;      ///< LCIDM: of time                                        [kg/s]
    CurveOr temperature;       ///< LCIDT: of time                                           [K]
};

/// *AIRBAG_SIMPLE_PRESSURE_VOLUME: no gas, but a gauge pressure that the volume gives,
///
///     p = BETA CN / (V / V0),   or a curve of V / V0,   V0 the volume at the start.
struct VolumeLaw {
    CurveOr coefficient;  ///< CN, of time                                              [Pa]
    double scale = 1.0;   ///< BETA: factor on the pressure                          [-]
    Index curve = -1;     ///< LCID: pressure over V / V0, instead of these             [Pa]
};

/// *AIRBAG_INTERACTION: gas of one bag of uniform pressure flows into another.
struct ExchangeCard {
    std::array<Index, 2> bags{-1, -1};  ///< rows of Model::uniform_bags
    ExitCard opening;   ///< SF, of time; AREA, of absolute pressure; or the shells of PID
    Index rate = -1;    ///< LCID: mass flow over pressure difference, instead           [kg/s]
    int direction = 0;  ///< IFLOW: -1 from the first to the second alone, 1 the other way, 0 both
};

/// One bag of uniform pressure.
struct UniformBagCard {
    std::string keyword;          ///< for messages: "*AIRBAG_WANG_NEFSKE"
    int id = 0;                   ///< the _ID card's number, else order in the deck from 1
    std::string title;            ///< from the deck, may be empty
    std::vector<Index> shells;    ///< shell rows that close the bag
    double volume_scale = 1.0;    ///< VSCA: factor on the mesh's volume                     [-]
    double pressure_scale = 1.0;  ///< PSCA: factor on the load                              [-]
    double volume_taken = 0.0;    ///< VINI: V = VSCA · V of the mesh - VINI         [m^3]
    double cv = NaN,              ///< CV: heat capacity at constant volume  [J/(kg K)]
        cp = NaN;                 ///< CP: heat capacity at constant pressure  [J/(kg K)]
    CurveOr temperature;          ///< T, LCT: of the gas that comes in, of time     [K]
    Index mass_rate = -1;         ///< LCID, LCMT: of time                        [kg/s]
    std::vector<ExitCard> exits;  ///< holes out of the bag, into the atmosphere
    Index exit_rate = -1;         ///< LOU, LCEFR: mass flow out of gauge pressure [kg/s]
    double opens_at = 0.0;        ///< PPOP: gauge pressure from which exits are open [Pa]
    double p_atm = NaN;           ///< PE: pressure outside                                  [Pa]
    double density = NaN;         ///< RO: of the gas inside at the start      [kg/m^3]
    double overpressure = 0.0;    ///< POVER: gauge pressure at the start           [Pa]
    double start_temperature =
        NaN;  ///< IABT: of the gas inside at the start, RO follows; NaN: from RO     [K]
    std::vector<UniformLeak> leaks;     ///< fabric of the bag that leaks
    std::vector<UniformGasCard> gases;  ///< in the place of cv, cp, temperature, mass_rate, density
    double gas_constant = NaN;          ///< GC, of `gases`                        [J/(mol K)]
    std::optional<VolumeLaw> law;       ///< in the place of all gas
};

}  // namespace corpuscle::gas
