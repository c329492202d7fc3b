// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/airbag/airbag_gas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>

namespace corpuscle::io::keywords {

namespace {

constexpr double AIR_MOLAR_MASS = 0.0289652;  ///< dry air                          [kg/mol]
constexpr double AIR_A = 3.5 * GAS_CONSTANT;  ///< diatomic                         [J/(mol K)]
constexpr double HEAVIEST_MOLE = 1e-3;        ///< [t/mol]: XM above it was meant in kg/mol
constexpr double LEAST_MILLIJOULES = 1e3;     ///< [mJ/(mol K)]: A below it was meant in J
constexpr double DEGREE = std::numbers::pi / 180.0;

constexpr double COLDEST = 250.0;       ///< of what is asked of a gas           [K]
constexpr double HOTTEST_AIR = 1500.0;  ///< air of the start, by what flows in  [K]
constexpr double STAGNATION = 1.4;      ///< temperature at rest over that of the flow

/// Names of the fields that say a gas: molar mass, or minus the id of a gas, and Cp(T).
struct SpeciesFields {
    const char* mass;
    std::array<const char*, 3> cp;
};

gas::SpeciesCard written_gas(Card& c, const SpeciesFields& fields) {
    gas::SpeciesCard gas;
    if (c.good()) gas.molar_mass = c.real(fields.mass, POSITIVE);
    gas.A = c.real(fields.cp[0], POSITIVE);
    gas.B = c.real(fields.cp[1]);
    gas.C = c.real(fields.cp[2]);
    return gas;
}

/// Molar mass and Cp(T) have the deck's units of mass and energy.
/// @param hottest  that the gas may be                                                     [K]
gas::SpeciesCard species(Card& c, const SpeciesFields& fields, const Draft& draft,
                         const UnitSystem& unit, double hottest) {
    const char *const mass = fields.mass, *const A = fields.cp[0];
    const double id = -c.real(mass);
    if (id > 0.0)
        for (const char* name : fields.cp)
            c.harmless(name);  // those of the gas that is named count
    const gas::SpeciesCard gas =
        id > 0.0 ? defined_gas(c, mass, id, draft, COLDEST, hottest) : written_gas(c, fields);
    if (!c.good() || unit.mass == 1.0) return gas;
    if (gas.molar_mass > HEAVIEST_MOLE)
        c.fault(mass, "tonnes per mole for UNIT = 2, like 2.897e-5 for air");
    if (gas.A < LEAST_MILLIJOULES)
        c.fault(id > 0.0 ? mass : A,
                "millijoules per mole and kelvin for UNIT = 2, like 2.91e4 for air");
    return gas;
}

}  // namespace

gas::InitialAirCard initial_air(Cards& cards, const Draft& draft, const gas::BagCard& bag,
                                const UnitSystem& unit, int kind) {
    Card c = cards.next("PAIR TAIR XMAIR AAIR BAIR CAIR NPAIR NPRLX");
    gas::InitialAirCard air;
    air.pressure = c.real("PAIR", NON_NEGATIVE);
    air.temperature = c.real("TAIR", TEMPERATURE);
    if (air.pressure == 0.0) air.pressure = bag.p_atm;
    if (air.temperature == 0.0) air.temperature = bag.T_atm;
    air.is_particles = kind == 2 || kind == 4;
    air.flows_in = kind == -1;
    if (air.is_particles) {
        constexpr double MOST = 1e8;
        air.particles = static_cast<std::size_t>(c.integer("NPAIR", within(0.0, MOST)));
        if (c.real("NPRLX") >= 0.0)
            c.noted("NPRLX", "initial air is at equilibrium from the start");
        else if (kind == 2)
            c.fault("NPRLX", ">= 0: initial air always presses on the fabric");
    } else {
        c.harmless("NPAIR NPRLX");
    }
    if (c.real("XMAIR") == 0.0 && c.real("AAIR") == 0.0) {
        c.warn("XMAIR", "dry air is taken, 0.0289652 kg/mol and Cp = 7/2 R");
        c.harmless("BAIR CAIR");
        air.species.molar_mass = AIR_MOLAR_MASS * unit.mass;
        air.species.A = AIR_A * unit.energy;
    } else {
        air.species = species(c, {"XMAIR", {"AAIR", "BAIR", "CAIR"}}, draft, unit, HOTTEST_AIR);
    }
    return air;
}

namespace {

/// Of a gas whose temperature over time is the curve, once it is at rest.                     [K]
double hottest_of(const Draft& draft, Index curve) {
    constexpr double LEAST = 1000.0;
    if (curve < 0) return LEAST;
    double most = LEAST;
    for (const double T : draft.model.curves[static_cast<std::size_t>(curve)].y)
        most = std::max(most, STAGNATION * T);
    return most;
}

}  // namespace

gas::InflowCard inflow(Cards& cards, const Draft& draft, const UnitSystem& unit) {
    Card c = cards.next("LCM LCT XM A B C INFG=1 -");
    gas::InflowCard gas;
    gas.mass_rate = c.row("LCM", draft.curves);
    gas.temperature = c.row("LCT", draft.curves);
    gas.species =
        species(c, {"XM", {"A", "B", "C"}}, draft, unit, hottest_of(draft, gas.temperature));
    gas.inflator = c.integer("INFG", {1.0});
    return gas;
}

namespace {

/// CA is the half angle of the cone: in degrees and only with IANG = 1 today, in radians in 2007.
/// What is assumed of it is said once a bag, at the first orifice.
double cone(Card& c, Dialect dialect, bool is_first) {
    constexpr double USUAL = 30.0;
    const bool radians = dialect == Dialect::NOTES_2007;
    const double written = c.real("CA", within(0.0, radians ? std::numbers::pi : 180.0));
    const bool is_used = radians || c.choice("IANG", {0, 1}) == 1;
    const auto say = [&](const char* remark) {
        if (is_first) c.warn("CA", remark);
    };
    if (written == 0.0) return USUAL * DEGREE;
    if (radians) return say("read in radians, as the cone's half angle (DIALECT = 2007)"), written;
    if (written <= std::numbers::pi)
        say("read in degrees but looks like radians, which are for -D DIALECT=2007");
    else if (is_used)
        say("read in degrees, as the cone's half angle");
    if (!is_used && written != USUAL)
        say("does not count without IANG = 1: the half angle is 30 degrees");
    return (is_used ? written : USUAL) * DEGREE;
}

/// VD: 0 every direction, > 0 a vector, -1 and -2 (-3 and -4 with another card) along a shell's
/// normal.
void direction(Card& c, const Draft& draft, gas::OrificeCard& nozzle, int vd) {
    if (vd < 0) {
        nozzle.shell = c.row("NID", draft.shells);
        nozzle.normal_sign = vd % 2 != 0 ? 1.0 : -1.0;
        return;
    }
    nozzle.node = c.row("NID", draft.nodes);
    const Index vector = c.row_or_none("VD", draft.vectors);
    if (vector >= 0) nozzle.direction = draft.vector[static_cast<std::size_t>(vector)].normalized();
}

/// Does the node belong to a shell?
bool has_mass(const Draft& draft, Index node) {
    const auto& shells = draft.model.shells;
    return std::any_of(shells.begin(), shells.end(), [&](const Shell& s) {
        return std::find(s.nodes.begin(), s.nodes.end(), node) != s.nodes.end();
    });
}

}  // namespace

gas::OrificeCard orifice(Cards& cards, const Draft& draft, const gas::OrificeCard* first) {
    gas::OrificeCard nozzle;
    int vd = 0;
    {
        Card c = cards.next(draft.dialect == Dialect::NOTES_2007
                                ? "NID AN VD CA INFO=1"
                                : "NID AN VD CA INFO=1 IMOM IANG CHM_ID");
        vd = c.integer("VD", {-4.0});
        direction(c, draft, nozzle, vd);
        nozzle.weight = c.real("AN", NON_NEGATIVE);
        if (first != nullptr && (first->weight > 0.0) != (nozzle.weight > 0.0))
            c.fault("AN", first->weight > 0.0 ? "> 0, as the first orifice has it"
                                              : "0 or blank, as the first orifice has it");
        nozzle.inflator = c.integer("INFO", {1.0});
        if (draft.dialect == Dialect::TODAY)
            c.noted("CHM_ID", "a nozzle is in the chamber that it lies in");
        nozzle.cone = cone(c, draft.dialect, /*is_first=*/first == nullptr);
        nozzle.pushes = draft.dialect == Dialect::TODAY && c.choice("IMOM", {0, 1}) == 1;
        if (nozzle.pushes && c.good() && nozzle.shell < 0 && !has_mass(draft, nozzle.node)) {
            nozzle.pushes = false;
            c.warn("IMOM", "node NID belongs to no shell and has no mass: the jet pushes nothing");
        }
    }
    if (vd <= -3) nozzle.offset = cards.next("XOFF").real("XOFF", NON_NEGATIVE);
    return nozzle;
}

}  // namespace corpuscle::io::keywords
