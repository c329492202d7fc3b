// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gas/cards/collision_model.hpp"
#include "gas/cards/opening_cards.hpp"
#include "solver/base/constants.hpp"
#include "solver/base/vec.hpp"

/// @file
/// What *AIRBAG_PARTICLE says of one bag, in deck units, defaults resolved, sets expanded to rows.

namespace corpuscle::gas {

/// One gas: molar heat capacity Cp(T) = A + B·T + C·T².
struct SpeciesCard {
    double molar_mass = NaN;  ///< XM                     [kg/mol]
    double A = NaN;           ///< constant part of Cp    [J/(mol K)]
    double B = 0.0;           ///< linear part            [J/(mol K^2)]
    double C = 0.0;           ///< quadratic part         [J/(mol K^3)]
};

/// A gas that flows in.
struct InflowCard {
    SpeciesCard species;     ///< its molar mass and heat capacity
    Index mass_rate = -1;    ///< LCM: curve row, mass flow over time              [kg/s]
    Index temperature = -1;  ///< LCT: curve row, static temperature over time     [K]
    int inflator = 1;        ///< INFG: number of the inflator that it comes from
};

/// A nozzle.
struct OrificeCard {
    Index node = -1;      ///< NID: node row of its place
    Index shell = -1;     ///< VD = -1, -2: shell row instead of a node; the flow follows its normal
    double weight = 1.0;  ///< AN: area, shares the gas among an inflator's orifices
    std::optional<Vec3> direction;  ///< VD > 0: direction of the vector; none: into every direction
    double normal_sign = 0.0;       ///< VD = -1: +1, VD = -2: -1
    double cone = NaN;    ///< half angle between the axis and the rim of the jet       [rad]
    int inflator = 1;     ///< INFO: number of the inflator that flows through it
    double offset = 0.0;  ///< XOFF: from the shell's centre, the way the gas flows [m]
    bool pushes = false;  ///< IMOM = 1: the jet pushes its node (or shell) back
};

/// Air that is in the bag at the start.
struct InitialAirCard {
    SpeciesCard species;        ///< its molar mass and heat capacity
    double pressure = NaN;      ///< PAIR: absolute pressure  [Pa]
    double temperature = NaN;   ///< TAIR: temperature  [K]
    bool is_particles = false;  ///< IAIR = 2; else it is one gas at uniform pressure
    bool flows_in = false;      ///< IAIR = -1: ambient air comes in where p < p_atm
    std::size_t particles = 0;  ///< NPAIR, beside NP; 0: a share of NP
};

/// Rough fabric: FRIC of card 1, or PFRIC of an NPDATA row.
struct FrictionCard {
    std::vector<Index> parts;  ///< part rows; none: all that no other card names
    /// 0 to 1: share of the velocity along the fabric that a bounce takes. Below 0, above -1: share
    /// of what lacks to a right angle by which the path after it leans towards the fabric.      [-]
    double factor = 0.0;
    Index curve = -1;  ///< in its place: over the part's absolute pressure
};

/// A closed room of a bag, *DEFINE_CPM_CHAMBER.
struct ChamberCard {
    int id = 0;                ///< CHM_ID, for results
    std::vector<Index> parts;  ///< part rows whose shells close it
};

/// The deck's units as far as gas asks for them, and the air outside.
struct AmbientCard {
    double gas_constant = GAS_CONSTANT;     ///< R in deck units (UNIT)                 [J/(mol K)]
    double second = 1.0;                    ///< one second in the deck's unit of time (UNIT)
    double p_atm = ATMOSPHERE_PRESSURE;     ///< PATM: outside, absolute                [Pa]
    double T_atm = ATMOSPHERE_TEMPERATURE;  ///< TATM: outside                       [K]
};

/// One *AIRBAG_PARTICLE.
struct BagCard : AmbientCard {
    std::string kind = "bag";           ///< for messages: "*AIRBAG_PARTICLE"
    int id = 0;                         ///< the _ID card's number, else order in the deck from 1
    std::string title;                  ///< from the deck, may be empty
    std::vector<Index> external_parts;  ///< SID1 without SID2: part rows whose shells close the bag
    std::vector<Index> internal_parts;  ///< SID2: part rows inside (tethers, diffusers, valves)
    std::size_t particles = 200000;  ///< NP: of all that flows in, and of initial air without NPAIR
    bool show_particles = true;      ///< VISFLG: frames hold its particles
    double all_in = 1e10;            ///< TEND: all particles have entered       [s]
    double switch_at = INF;          ///< TSW: uniform pressure from then on [s]
    std::vector<InflowCard> inflow;  ///< NGAS cards: gases that come in
    std::vector<OrificeCard> orifices;  ///< NORIF cards: where they come in
    std::optional<InitialAirCard> air;  ///< IAIR other than 0
    std::array<Index, 3> frame{-1, -1,
                               -1};  ///< NID1-3: node rows that directions turn with; -1: none
    bool is_of_2007 = false;         ///< the cards mean what they meant in the course notes
    std::optional<CollisionModel> collision;  ///< none: the collider's own choice
    double mean_free_path = NaN;              ///< of that model; NaN: its default        [m]
    std::vector<VentCard> vents;              ///< NVENT cards: holes, outward or between rooms
    std::vector<HeatCard> heat;               ///< HCONV of NPDATA cards
    std::vector<ChamberCard> chambers;        ///< CHM: rooms that internal parts divide it into
    BlockCard block;                          ///< BLOCK: what touching closes
    std::vector<FrictionCard> friction;       ///< FRIC and PFRIC that are not 0
    bool friction_pushes_along = true;  ///< IDFRIC = 0: fabric feels what bounces take; else not
    double normal_damping = 0.0;  ///< VNDAMP: adds to the gas's answer, in rho sqrt(R T / M) [-]
    double smoothing = 1.0;       ///< SFFDC, scales the time over which impulse is released [-]

    /// For messages: "*AIRBAG_PARTICLE 1".
    [[nodiscard]] std::string name() const { return kind + ' ' + std::to_string(id); }
};

}  // namespace corpuscle::gas
