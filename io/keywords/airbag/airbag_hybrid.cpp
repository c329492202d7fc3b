// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Bags of uniform pressure that hold a mixture, a gas that is given at the start alone, or a
// pressure that is given.

#include <fmt/format.h>

#include <algorithm>

#include "gas/enclosure/enclosure.hpp"
#include "io/keywords/airbag/airbag_uniform.hpp"
#include "io/keywords/keywords.hpp"
#include "solver/base/error.hpp"

namespace corpuscle::io::keywords {
namespace {

using gas::UniformBagCard;
using gas::UniformGasCard;

/// LCIDM LCIDT - MW INITM A B C, and the share of air that comes with it.
UniformGasCard gas_cards(Cards& cards, const Draft& draft) {
    UniformGasCard gas;
    {
        Card c = cards.next("LCIDM LCIDT - MW INITM A B C");
        gas.mass_rate = c.row_or_none("LCIDM", draft.curves);
        gas.temperature.curve = gas.mass_rate >= 0 ? c.row("LCIDT", draft.curves)
                                                   : c.row_or_none("LCIDT", draft.curves);
        gas.species.molar_mass = c.real("MW", POSITIVE);
        gas.start_share = c.real("INITM", within(0.0, 1.0));
        gas.species.A = c.real("A", POSITIVE);
        gas.species.B = c.real("B");
        gas.species.C = c.real("C");
    }
    cards.next("FMASS - - - - - - -");
    return gas;
}

/// What fills the bag at the start where no INITM says it: air by ATMOSD, M = rho R T / p, with 7/2
/// R.
UniformGasCard ambient_gas(const UniformBagCard& bag, double density, double T) {
    UniformGasCard air;
    air.species.molar_mass = density * bag.gas_constant * T / bag.p_atm;
    air.species.A = 3.5 * bag.gas_constant;
    air.start_share = 1.0;
    return air;
}

}  // namespace

void airbag_hybrid(Cards& cards, Draft& draft) {
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_HYBRID");
    double density = 0.0;
    {
        Card c = cards.next("ATMOST ATMOSP ATMOSD GC CC=1 HCONV - -");
        bag.start_temperature = c.real("ATMOST", POSITIVE);
        bag.p_atm = c.real("ATMOSP", POSITIVE);
        density = c.real("ATMOSD", NON_NEGATIVE);
        bag.gas_constant = c.real("GC", POSITIVE);
    }
    {
        Card c = cards.next("C23 LCC23 A23 LCA23 CP23 LCP23 AP23 LCAP23");
        bag.exits = {exit_card(c, draft, "C23", "LCC23", "A23", "LCA23"),
                     exit_card(c, draft, "CP23", "LCP23", "AP23", "LCAP23")};
    }
    int gases = 0, option = 0;
    {
        Card c = cards.next("OPT PVENT NGAS LCEFR LCIDM0 VNTOPT - -");
        option = c.choice("OPT", {0, 1, 2, 3, 4, 5, 6, 7, 8});
        bag.opens_at = c.real("PVENT", NON_NEGATIVE);
        gases = c.integer("NGAS", within(1.0, 17.0));
        bag.exit_rate = c.row_or_none("LCEFR", draft.curves);
        c.noted("VNTOPT", "the vent has the area of its shells as it is at the time");
    }
    double start = 0.0;
    for (int k = 0; k < gases; ++k) {
        bag.gases.push_back(gas_cards(cards, draft));
        start += bag.gases.back().start_share;
    }
    if (start == 0.0 && density > 0.0 && cards.good()) {
        bag.gases.push_back(ambient_gas(bag, density, bag.start_temperature));
        cards.warn("has no INITM: air of density ATMOSD fills the bag at the start");
    } else if (std::abs(start - 1.0) > 0.01 && cards.good()) {
        cards.fault(
            fmt::format("has INITM that add up to {:g}, expected 1, or 0 and ATMOSD", start));
    }
    skip_jets(cards, 3);
    fabric_leaks(cards, draft, option, bag);
    keep_bag(cards, draft, std::move(bag));
}

/// p = (P0 + PE) (V0 / V)^GAMMA: a gas that nothing enters or leaves, P0 its gauge pressure at the
/// start. Its temperature is not given; 300 is taken.
void airbag_adiabatic(Cards& cards, Draft& draft) {
    constexpr double SOME_TEMPERATURE = 300.0;
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_ADIABATIC_GAS_MODEL");
    Card c = cards.next("PSF=1 LCID GAMMA P0 PE RO - -");
    bag.pressure_scale *= c.real("PSF", POSITIVE);
    const double gamma = c.real("GAMMA", {1.0, INF, true}), gauge = c.real("P0");
    bag.p_atm = c.real("PE", NON_NEGATIVE);
    bag.density = c.real("RO", POSITIVE);
    const double p = gauge + bag.p_atm;
    if (c.good() && !(p > 0.0)) c.fault("P0", "a gauge pressure, with P0 + PE > 0");
    if (!c.good()) return;
    if (bag.p_atm > 0.0 && gauge >= bag.p_atm)
        c.note("P0", fmt::format("a gauge pressure: the bag starts at P0 + PE = {:g}", p));
    const double R = p / (bag.density * SOME_TEMPERATURE);
    bag.cv = R / (gamma - 1.0);
    bag.cp = gamma * bag.cv;
    bag.overpressure = gauge;
    keep_bag(cards, draft, std::move(bag));
}

/// A gauge pressure that the volume gives: p = BETA CN / (V / V0), or a curve of V / V0.
void airbag_pressure_volume(Cards& cards, Draft& draft) {
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_SIMPLE_PRESSURE_VOLUME");
    Card c = cards.next("CN BETA=1 LCID LCIDDR - - - -");
    gas::VolumeLaw law;
    law.curve = c.row_or_none("LCID", draft.curves);
    law.scale = c.real("BETA");
    law.coefficient = value_or_curve(c, "CN", draft.curves);
    if (law.curve >= 0 && (c.real("CN") != 0.0 || law.scale != 1.0))
        c.warn("LCID", "pressure over V / V0 goes before CN and BETA");
    c.harmless("LCIDDR");  // of dynamic relaxation
    const bool has_none = law.curve < 0 && law.coefficient.curve < 0 && c.real("CN") == 0.0;
    if (has_none && c.good()) c.fault("CN", "a number, minus the id of a curve of time, or LCID");
    if (!c.good()) return;
    bag.cv = 2.5, bag.cp = 3.5;  // of no gas
    bag.p_atm = 0.0;
    bag.law = law;
    cards.warn("is a pressure by volume: it has no gas, its history's mass and temperature are 0");
    keep_bag(cards, draft, std::move(bag));
}

namespace {

/// Row of the bag of uniform pressure that the field names, -1 with a fault.
Index bag_named(Card& c, const Draft& draft, const char* field) {
    const int id = c.id(field, IdKind::OTHER);
    const auto& bags = draft.model.uniform_bags;
    for (std::size_t b = 0; b < bags.size(); ++b)
        if (bags[b].id == id && !bags[b].law) return static_cast<Index>(b);
    c.fault(field,
            "the id of a bag of uniform pressure with gas (*AIRBAG_..._ID, or its place "
            "among the deck's airbags)");
    return -1;
}

bool is_same_gas(const UniformBagCard& a, const UniformBagCard& b) {
    const auto differ = [](double u, double v) {
        return std::abs(u - v) > 1e-9 * (std::abs(u) + std::abs(v));
    };
    if (a.gases.size() != b.gases.size()) return false;
    if (a.gases.empty()) return !differ(a.cv, b.cv) && !differ(a.cp, b.cp);
    for (std::size_t k = 0; k < a.gases.size(); ++k) {
        const auto &u = a.gases[k].species, &v = b.gases[k].species;
        if (differ(u.molar_mass, v.molar_mass) || differ(u.A, v.A) || differ(u.B, v.B) ||
            differ(u.C, v.C))
            return false;
    }
    return !differ(a.gas_constant, b.gas_constant);
}

}  // namespace

/// Two bags of uniform pressure that vent into each other.
void airbag_interaction(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        Card c = cards.next("AB1 AB2 AREA SF=1 PID LCID IFLOW -");
        gas::ExchangeCard hole;
        hole.bags = {bag_named(c, draft, "AB1"), bag_named(c, draft, "AB2")};
        hole.rate = c.row_or_none("LCID", draft.curves);
        const int flow = c.integer("IFLOW");
        hole.direction = (flow > 0) - (flow < 0);
        hole.opening.coefficient = value_or_curve(c, "SF", draft.curves);
        hole.opening.area = value_or_curve(c, "AREA", draft.curves);
        const bool has_area = hole.opening.area.value > 0.0 || hole.opening.area.curve >= 0;
        const int part = c.integer("PID", NON_NEGATIVE);
        if (!c.good()) continue;
        if (hole.bags[0] == hole.bags[1]) c.fault("AB2", "another bag than AB1");
        if (!has_area && hole.rate < 0)
            hole.opening.facets = facets_of_part(
                c, draft, "PID", part, "the id of a *PART with shells in it, for AREA is blank");
        const auto& bags = draft.model.uniform_bags;
        if (c.good() && !is_same_gas(bags[static_cast<std::size_t>(hole.bags[0])],
                                     bags[static_cast<std::size_t>(hole.bags[1])]))
            c.fault("AB2", "a bag of the same gases as AB1");
        if (c.good()) draft.model.exchanges.push_back(std::move(hole));
    }
}

/// A gauge pressure over time, on the bag's inside.
void airbag_load_curve(Cards& cards, Draft& draft) {
    const UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_LOAD_CURVE");
    Card c = cards.next("STIME LCID RO PE P0 T T0 -");
    PressureLoad load;
    load.arrival = c.real("STIME", NON_NEGATIVE);
    load.curve = c.row("LCID", draft.curves);
    load.scale = bag.pressure_scale;
    c.harmless("RO PE P0 T T0");  // the curve goes before
    if (!c.good()) return;
    std::vector<Triangle> triangles;
    for (const Index s : bag.shells) {
        const auto& n = draft.model.shells[static_cast<std::size_t>(s)].nodes;
        if (std::any_of(n.begin(), n.end(), [](Index node) { return node < 0; })) return;
        triangles.push_back({n[0], n[1], n[2]});
        if (n[2] != n[3]) triangles.push_back({n[0], n[2], n[3]});
    }
    try {
        const gas::Enclosure closed(triangles, draft.model.x, draft.model.node_id,
                                    "*AIRBAG_LOAD_CURVE");
        triangles = closed.triangles();  // outward
        for (Triangle& t : triangles) std::swap(t[1], t[2]);
    } catch (const InputError&) {
        cards.warn("is not closed: its pressure acts against the normals of its facets");
    }
    for (const Triangle& t : triangles) load.facets.push_back({t[0], t[1], t[2], t[2]});
    cards.warn("is a pressure that is given: it has no gas, and no history of one");
    draft.model.pressure_loads.push_back(std::move(load));
}

}  // namespace corpuscle::io::keywords
