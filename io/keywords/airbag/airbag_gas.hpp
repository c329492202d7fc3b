// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include "gas/cards/bag.hpp"
#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

/// The rows of *AIRBAG_PARTICLE that say which gas comes from where.
namespace corpuscle::io::keywords {

/// UNIT of *AIRBAG_PARTICLE: what R, the atmosphere and the heat capacities are in the deck's
/// units.
struct UnitSystem {
    const char* name;
    double energy;    ///< deck units of energy in a joule
    double pressure;  ///< deck units of pressure in a pascal
    double mass;      ///< deck units of mass in a kilogram
    double second;    ///< deck units of time in a second
};
inline constexpr UnitSystem UNIT_SYSTEMS[] = {
    {"kg-mm-ms-K", 1.0, 1e-9, 1.0, 1e3},  // kg mm^2/ms^2 = J, GPa
    {"SI", 1.0, 1.0, 1.0, 1.0},
    {"ton-mm-s-K", 1e3, 1e-6, 1e-3, 1.0},  // t mm^2/s^2 = mJ, MPa
};

/// Of gas; 0 or blank has a default. Beyond, particles would cross the bag millions of times a
/// step.
inline constexpr Range TEMPERATURE = within(0.0, 1e5);  ///< [K]

/// @param kind  IAIR: 1, -1, 2, or 4, which is taken as 2
gas::InitialAirCard initial_air(Cards& cards, const Draft& draft, const gas::BagCard& bag,
                                const UnitSystem& unit, int kind);
gas::InflowCard inflow(Cards& cards, const Draft& draft, const UnitSystem& unit);
/// The gas of the *DEFINE_CPM_GAS_PROPERTIES `id`, named by a row's field `mass` = -id. A Cp of
/// fourth order becomes A + B T + C T^2, told with the difference, or is refused.
/// @param low, high  temperatures that the gas may have                                    [K]
gas::SpeciesCard defined_gas(Card& c, const char* mass, double id, const Draft& draft, double low,
                             double high);
/// @param first  of the bag, nullptr for this one: with an area AN all have one, without none
gas::OrificeCard orifice(Cards& cards, const Draft& draft, const gas::OrificeCard* first);

/// _MOLEFRACTION: until here the gases' `mass_rate` are mole fractions of time; afterwards they are
/// mass flows, new curves of the model. A fault when the fractions are no shares of 1.
///
///     m_i' = m' x_i M_i / sum x_k M_k
///
/// @param mass  curve row: flow of all gases together                                  [kg/s]
void share_by_moles(Cards& cards, Draft& draft, Index mass, std::vector<gas::InflowCard>& gases);

}  // namespace corpuscle::io::keywords
