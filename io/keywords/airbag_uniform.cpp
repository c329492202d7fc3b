// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Bags of uniform pressure that never hold particles.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

using gas::UniformBagCard;

std::array<Index, 4> sorted(std::array<Index, 4> nodes) {
    std::sort(nodes.begin(), nodes.end());
    return nodes;
}

/// A triangle's four entries name three nodes, in whatever place the repeated one stands.
std::vector<Index> corners(const std::array<Index, 4>& nodes) {
    const auto all = sorted(nodes);
    std::vector<Index> some(all.begin(), all.end());
    some.erase(std::unique(some.begin(), some.end()), some.end());
    return some;
}

/// The shells that the segments of a set lie on.
void shells_of_segments(Card& c, const Draft& draft, std::vector<Index>& shells) {
    const Index row = c.row("SID", draft.segment_sets);
    if (row < 0) return;
    std::map<std::vector<Index>, Index> by_nodes;
    const auto& all = draft.model.shells;
    for (std::size_t s = 0; s < all.size(); ++s)
        by_nodes.try_emplace(corners(all[s].nodes), static_cast<Index>(s));
    std::size_t bare = 0;
    for (const auto& segment : draft.segment_set[static_cast<std::size_t>(row)]) {
        const auto at = by_nodes.find(corners(segment));
        if (at == by_nodes.end())
            ++bare;
        else
            shells.push_back(at->second);
    }
    if (bare > 0)
        c.fault("SID", fmt::format("segments that lie on shells: {} of this set do not", bare));
}

void shells_of_parts(Card& c, const Draft& draft, std::vector<Index>& shells) {
    const Index row = c.row("SID", draft.part_sets);
    if (row < 0) return;
    const auto& parts = draft.part_set[static_cast<std::size_t>(row)];
    const auto& all = draft.model.shells;
    for (std::size_t s = 0; s < all.size(); ++s)
        if (std::find(parts.begin(), parts.end(), all[s].part) != parts.end())
            shells.push_back(static_cast<Index>(s));
    if (shells.empty()) c.fault("SID", "parts with shells in them");
}

/// The card that all control volumes begin with.
UniformBagCard control_volume(Cards& cards, const Draft& draft, const char* keyword) {
    UniformBagCard bag;
    bag.keyword = keyword;
    bag.id = static_cast<int>(draft.model.bags.size() + draft.model.uniform_bags.size()) + 1;
    if (cards.has("ID")) {
        Card c = cards.next("ID TITLE:70");
        bag.id = c.integer("ID", {1.0});
        bag.title = c.text("TITLE");
    }
    Card c = cards.next("SID SIDTYP RBID VSCA=1 PSCA=1 VINI MWD SPSF");
    if (c.integer("SIDTYP") == 0)
        shells_of_segments(c, draft, bag.shells);
    else
        shells_of_parts(c, draft, bag.shells);
    bag.volume_scale = c.real("VSCA", POSITIVE);
    bag.pressure_scale = c.real("PSCA", POSITIVE);
    bag.volume_taken = c.real("VINI");
    return bag;
}

/// Heat capacities per mass; 0 for CV: they come with the molar ones of a later card.
void heat_capacities(Card& c, UniformBagCard& bag) {
    bag.cv = c.real("CV", NON_NEGATIVE);
    bag.cp = c.real("CP", NON_NEGATIVE);
    if (c.good() && bag.cv > 0.0 && !(bag.cp > bag.cv)) c.fault("CP", "more than CV");
}

/// cp = (A + B T) / MW and cv = cp - GASC / MW, with T = TEXT throughout.
void molar_heat_capacities(Card& c, UniformBagCard& bag) {
    const double T = c.real("TEXT", POSITIVE), M = c.real("MW", POSITIVE);
    const double molar = c.real("A") + c.real("B") * T, R = c.real("GASC", POSITIVE);
    if (c.good() && !(molar > R)) c.fault("A", "A + B TEXT > GASC, for CV = A + B TEXT - GASC");
    bag.cp = molar / M;
    bag.cv = (molar - R) / M;
}

/// A value, or below 0 the id of a curve.
gas::CurveOr value_or_curve(Card& c, const char* name, const Registry& curves) {
    const double value = c.real(name);
    if (!c.good() || value >= 0.0) return {value};
    const Registry::Entry* entry = value > -1e9 ? curves.find(static_cast<int>(-value)) : nullptr;
    if (entry == nullptr || value != std::floor(value)) {
        c.fault(name, ">= 0, or minus the id of a *DEFINE_CURVE of the deck");
        return {};
    }
    return {0.0, entry->row};
}

void keep(Cards& cards, Draft& draft, UniformBagCard bag) {
    const auto is_same = [&](const auto& other) { return other.id == bag.id; };
    Model& model = draft.model;
    if (std::any_of(model.bags.begin(), model.bags.end(), is_same) ||
        std::any_of(model.uniform_bags.begin(), model.uniform_bags.end(), is_same))
        cards.fault(fmt::format("has id {}, as another airbag has", bag.id));
    model.uniform_bags.push_back(std::move(bag));
}

}  // namespace

void airbag_simple(Cards& cards, Draft& draft) {
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_SIMPLE_AIRBAG_MODEL");
    {
        Card c = cards.next("CV CP T LCID MU AREA PE RO");
        heat_capacities(c, bag);
        bag.mass_rate = c.row_or_none("LCID", draft.curves);
        bag.temperature.value = c.real("T", bag.mass_rate >= 0 ? POSITIVE : NON_NEGATIVE);
        gas::ExitCard exit;
        exit.coefficient = value_or_curve(c, "MU", draft.curves);
        exit.coefficient_of_pressure = true;
        exit.area = value_or_curve(c, "AREA", draft.curves);
        bag.exits = {exit};
        bag.p_atm = c.real("PE", POSITIVE);
        bag.density = c.real("RO", POSITIVE);
    }
    if (bag.cv == 0.0 || cards.more()) {
        Card c = cards.next("LOU TEXT A B MW GASC - -");
        bag.exit_rate = c.row_or_none("LOU", draft.curves);
        if (bag.cv == 0.0)
            molar_heat_capacities(c, bag);
        else
            c.harmless("TEXT A B MW GASC");
    }
    keep(cards, draft, std::move(bag));
}

namespace {

/// Vent (23) and leak (p23): a coefficient over time and an area over absolute pressure.
gas::ExitCard exit(Card& c, const Draft& draft, const char* C, const char* C_curve, const char* A,
                   const char* A_curve) {
    gas::ExitCard exit;
    exit.coefficient = {c.real(C, NON_NEGATIVE), c.row_or_none(C_curve, draft.curves)};
    exit.area = {c.real(A, NON_NEGATIVE), c.row_or_none(A_curve, draft.curves)};
    return exit;
}

}  // namespace

void airbag_wang_nefske(Cards& cards, Draft& draft) {
    UniformBagCard bag = control_volume(cards, draft, "*AIRBAG_WANG_NEFSKE");
    {
        Card c = cards.next("CV CP T LCT LCMT TVOL LCDT IABT");
        heat_capacities(c, bag);
        bag.mass_rate = c.row("LCMT", draft.curves);
        bag.temperature.curve = c.row_or_none("LCT", draft.curves);
        bag.temperature.value = c.real("T", bag.temperature.curve < 0 ? POSITIVE : NON_NEGATIVE);
    }
    {
        Card c = cards.next("C23 LCC23 A23 LCA23 CP23 LCCP23 AP23 LCAP23");
        bag.exits = {exit(c, draft, "C23", "LCC23", "A23", "LCA23"),
                     exit(c, draft, "CP23", "LCCP23", "AP23", "LCAP23")};
    }
    {
        Card c = cards.next("PE RO GC LCEFR POVER PPOP OPT=1 KNKDN");
        bag.p_atm = c.real("PE", POSITIVE);
        bag.density = c.real("RO", POSITIVE);
        if (const double g = c.real("GC"); g != 0.0 && g != 1.0)
            c.fault("GC", "0 or 1: units are consistent");
        bag.exit_rate = c.row_or_none("LCEFR", draft.curves);
        bag.overpressure = c.real("POVER", NON_NEGATIVE);
        bag.opens_at = c.real("PPOP", NON_NEGATIVE);
        c.choice("OPT", {0, 1}, {2, 3, 4, 5, 6, 7, 8});
    }
    if (bag.cv == 0.0) {
        Card c = cards.next("TEXT A B MW GASC HCONV");
        molar_heat_capacities(c, bag);
    }
    keep(cards, draft, std::move(bag));
}

}  // namespace corpuscle::io::keywords
