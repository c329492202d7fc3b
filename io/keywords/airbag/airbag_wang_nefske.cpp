// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *AIRBAG_WANG_NEFSKE.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/keywords/airbag/airbag_uniform.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

using gas::UniformBagCard;

/// The inflator card is always there; it counts only without LCMT, where it is refused. With CV = 0
/// the card of heat capacities is behind it.
void inflator_and_capacities(Cards& cards, UniformBagCard& bag) {
    const std::size_t left = cards.lines_left();
    const bool is_molar = bag.cv == 0.0, has_jets = cards.has("JETTING");
    if (left > (is_molar ? 1U : 0U)) {
        Card c = cards.next("IOC IOA IVOL IRO IT LCBF - -");
        for (const char* name : {"IOC", "IOA", "IVOL", "IRO", "IT", "LCBF"})
            if (c.given(name) && c.real(name) != 0.0) {
                c.note(name, "with LCMT the inflator card does not count");
                break;
            }
        c.harmless_all();
    } else if (is_molar && left == 1) {
        cards.warn(
            "has no inflator card (IOC IOA IVOL IRO IT LCBF, blank with LCMT): with CV = 0 "
            "its last card is taken for TEXT A B MW GASC HCONV");
    }
    if (is_molar) {
        Card c = cards.next("TEXT A B MW GASC HCONV");
        molar_heat_capacities(c, bag);
    } else if (cards.lines_left() > 0 && !has_jets) {
        cards.next("TEXT A B MW GASC HCONV - -").harmless_all();  // CV counts
    }
}

gas::LeakLaw law_of(int option) {
    if (option == 1 || option == 2) return gas::LeakLaw::ORIFICE;
    if (option == 3 || option == 4) return gas::LeakLaw::HEAD;
    if (option == 5 || option == 6) return gas::LeakLaw::POROUS;
    return gas::LeakLaw::VELOCITY;
}

}  // namespace

gas::ExitCard exit_card(Card& c, const Draft& draft, const char* C, const char* C_curve,
                        const char* A, const char* A_curve) {
    gas::ExitCard exit;
    exit.coefficient = {c.real(C, NON_NEGATIVE), c.row_or_none(C_curve, draft.curves)};
    const double area = c.real(A);
    if (area < 0.0)
        exit.facets = facets_of_part(c, draft, A, -area,
                                     ">= 0, or minus the id of a *PART with shells in it");
    else
        exit.area.value = area;
    exit.area.curve = c.row_or_none(A_curve, draft.curves);
    return exit;
}

void fabric_leaks(Cards& cards, const Draft& draft, int option, UniformBagCard& bag) {
    bool is_blocked = false;
    for (const Index part : parts_of(draft, bag)) {
        const fabric::FabricCard* cloth = leakage_of(draft.model, part);
        if (cloth == nullptr) continue;
        const int own = cloth->leak_option != 0 ? cloth->leak_option : option;
        is_blocked |= own > 0 && own % 2 == 0;
        if (cloth->leak_option < 0)
            cards.fault(fmt::format(
                "has part {}, whose material leaks with FVOPT = {}, expected 0 "
                "to 8",
                draft.model.parts[static_cast<std::size_t>(part)].id, cloth->leak_option));
        bag.leaks.push_back({part,
                             {cloth->leak_area, cloth->leak_area_curve},
                             {cloth->leak_velocity, cloth->leak_velocity_curve},
                             law_of(cloth->leak_option != 0 ? cloth->leak_option : option),
                             cloth->leak_growth});
    }
    if (bag.leaks.empty()) return;
    if (is_blocked)
        cards.warn(
            "has fabric that leaks with an even FVOPT or OPT: what touches is not taken out "
            "of the leak here, more leaves than would");
    gas::ExitCard& leak = bag.exits.at(1);
    const auto counts = [](const gas::CurveOr& of) { return of.value != 0.0 || of.curve >= 0; };
    if (counts(leak.coefficient) && counts(leak.area))
        cards.warn(
            "has CP23 and AP23, and parts whose material leaks (FLC, FAC): the material's "
            "leakage counts, CP23 and AP23 do not");
    leak = {};
    leak.coefficient.value = 0.0;
}

void airbag_wang_nefske(Cards& cards, Draft& draft) {
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_WANG_NEFSKE");
    int option = 1;
    {
        Card c = cards.next("CV CP T LCT LCMT TVOL LCDT IABT");
        heat_capacities(c, bag);
        bag.mass_rate = c.row("LCMT", draft.curves);
        bag.temperature.curve = c.row_or_none("LCT", draft.curves);
        bag.temperature.value = c.real("T", bag.temperature.curve < 0 ? POSITIVE : NON_NEGATIVE);
        if (const double start = c.real("IABT", NON_NEGATIVE); start > 0.0) {
            bag.start_temperature = start;
            c.warn("IABT",
                   "temperature of the gas inside at the start: its density follows from it and "
                   "the pressure PE + POVER, RO does not count");
        }
    }
    {
        Card c = cards.next("C23 LCC23 A23 LCA23 CP23 LCCP23 AP23 LCAP23");
        bag.exits = {exit_card(c, draft, "C23", "LCC23", "A23", "LCA23"),
                     exit_card(c, draft, "CP23", "LCCP23", "AP23", "LCAP23")};
    }
    {
        Card c = cards.next("PE RO GC LCEFR POVER PPOP OPT=1 KNKDN");
        bag.p_atm = c.real("PE", POSITIVE);
        bag.density = c.real("RO", bag.start_temperature > 0.0 ? NON_NEGATIVE : POSITIVE);
        if (const double g = c.real("GC"); g != 0.0 && g != 1.0)
            c.fault("GC", "0 or 1: units are consistent");
        bag.exit_rate = c.row_or_none("LCEFR", draft.curves);
        bag.overpressure = c.real("POVER", NON_NEGATIVE);
        bag.opens_at = c.real("PPOP", NON_NEGATIVE);
        option = c.choice("OPT", {0, 1, 2, 3, 4, 5, 6, 7, 8});
    }
    inflator_and_capacities(cards, bag);
    skip_jets(cards, 2);
    fabric_leaks(cards, draft, option, bag);
    keep_bag(cards, draft, std::move(bag));
}

}  // namespace corpuscle::io::keywords
