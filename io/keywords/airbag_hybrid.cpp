// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Bags of uniform pressure that hold a mixture, a gas that is given at the start alone, or a
// pressure that is given.

#include <fmt/format.h>

#include <algorithm>

#include "gas/enclosure/enclosure.hpp"
#include "io/keywords/airbag_uniform.hpp"
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

/// Cards of _JETTING: the gas is uniform here, so they push nothing.
void skip_jets(Cards& cards) {
    if (!cards.has("JETTING")) return;
    static const Layout any("- - - - - - - -");
    cards.warn("has jets, which do not act: its gas presses alike everywhere");
    for (int card = 0; card < 3 && cards.lines_left() > 0; ++card) cards.next(any).harmless_all();
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
    skip_jets(cards);
    fabric_leaks(cards, draft, option, bag);
    keep_bag(cards, draft, std::move(bag));
}

/// p = P0 (V0 / V)^GAMMA: a gas that nothing enters or leaves. Its temperature is not given; 300 is
/// taken.
void airbag_adiabatic(Cards& cards, Draft& draft) {
    constexpr double SOME_TEMPERATURE = 300.0;
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_ADIABATIC_GAS_MODEL");
    Card c = cards.next("PSF=1 LCID GAMMA P0 PE RO - -");
    bag.pressure_scale *= c.real("PSF", POSITIVE);
    const double gamma = c.real("GAMMA", {1.0, INF, true}), p = c.real("P0", POSITIVE);
    bag.p_atm = c.real("PE", NON_NEGATIVE);
    bag.density = c.real("RO", POSITIVE);
    if (!c.good()) return;
    const double R = p / (bag.density * SOME_TEMPERATURE);
    bag.cv = R / (gamma - 1.0);
    bag.cp = gamma * bag.cv;
    bag.overpressure = p - bag.p_atm;
    keep_bag(cards, draft, std::move(bag));
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
