// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Bags of uniform pressure that never hold particles.

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "io/keywords/airbag/airbag_uniform.hpp"
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
    if (bare > 0 && !draft.is_incomplete)
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
    if (shells.empty() && !draft.is_incomplete) c.fault("SID", "parts with shells in them");
}

}  // namespace

std::vector<Index> parts_of(const Draft& draft, const UniformBagCard& bag) {
    std::vector<Index> parts;
    for (const Index shell : bag.shells) {
        const Index part = draft.model.shells[static_cast<std::size_t>(shell)].part;
        if (part >= 0 && std::find(parts.begin(), parts.end(), part) == parts.end())
            parts.push_back(part);
    }
    return parts;
}

void heat_capacities(Card& c, UniformBagCard& bag) {
    bag.cv = c.real("CV", NON_NEGATIVE);
    bag.cp = c.real("CP", NON_NEGATIVE);
    if (c.good() && bag.cv > 0.0 && !(bag.cp > bag.cv)) c.fault("CP", "more than CV");
}

void molar_heat_capacities(Card& c, UniformBagCard& bag) {
    const double T = c.real("TEXT", POSITIVE), M = c.real("MW", POSITIVE);
    const double molar = c.real("A") + c.real("B") * T, R = c.real("GASC", POSITIVE);
    if (c.good() && !(molar > R)) c.fault("A", "A + B TEXT > GASC, for CV = A + B TEXT - GASC");
    bag.cp = molar / M;
    bag.cv = (molar - R) / M;
}

gas::CurveOr value_or_curve(Card& c, const char* name, const Registry& curves) {
    const double value = c.real(name);
    if (!c.good() || value >= 0.0) return {value};
    const Registry::Entry* entry = c.named(name, -value, curves);
    if (entry == nullptr) {
        c.fault(name, ">= 0, or minus the id of a *DEFINE_CURVE of the deck");
        return {};
    }
    return {0.0, entry->row};
}

std::vector<std::array<Index, 4>> facets_of_part(Card& c, const Draft& draft, const char* field,
                                                 double id, const char* expected) {
    const Registry::Entry* entry = c.named(field, id, draft.parts);
    std::vector<std::array<Index, 4>> facets;
    if (entry != nullptr)
        for (const Shell& shell : draft.model.shells)
            if (shell.part == entry->row) facets.push_back(shell.nodes);
    if (facets.empty() && !draft.is_incomplete) c.fault(field, expected);
    return facets;
}

void skip_jets(Cards& cards, int most) {
    if (!cards.has("JETTING")) return;
    static const Layout any("- - - - - - - -");
    cards.warn("has jets, which do not act: its gas presses alike everywhere");
    for (int card = 0; card < most && cards.lines_left() > 0; ++card)
        cards.next(any).harmless_all();
}

UniformBagCard control_volume(Cards& cards, const Draft& draft, const char* keyword) {
    UniformBagCard bag;
    bag.keyword = keyword;
    if (cards.has("ID")) {
        Card c = cards.next("ID TITLE:70");
        bag.id = c.id("ID", IdKind::OTHER, NON_NEGATIVE);
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

namespace {

/// Whether gas can leave through exits or fabric.
bool has_exits(const UniformBagCard& bag) {
    const auto is_there = [](const gas::CurveOr& some) {
        return some.curve >= 0 || some.value != 0.0;
    };
    return !bag.leaks.empty() ||
           std::any_of(bag.exits.begin(), bag.exits.end(), [&](const gas::ExitCard& exit) {
               return is_there(exit.coefficient) && (!exit.facets.empty() || is_there(exit.area));
           });
}

}  // namespace

void keep_bag(Cards& cards, Draft& draft, UniformBagCard bag) {
    if (bag.exit_rate >= 0 && has_exits(bag))
        cards.warn(
            "has a curve of mass flow out (LOU, LCEFR): it stands in the place of the exits and "
            "of fabric that leaks, which do not count beside it");
    const auto is_same = [&](const auto& other) { return bag.id != 0 && other.id == bag.id; };
    Model& model = draft.model;
    if (std::any_of(model.bags.begin(), model.bags.end(), is_same) ||
        std::any_of(model.uniform_bags.begin(), model.uniform_bags.end(), is_same))
        cards.fault(fmt::format("has id {}, as another airbag has", bag.id));
    model.uniform_bags.push_back(std::move(bag));
}

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
    for (const Index part : parts_of(draft, bag))
        if (leakage_of(draft.model, part) != nullptr) {
            cards.warn(
                fmt::format("has part {}, whose material leaks (FLC, FAC): this model knows "
                            "MU and AREA alone, the leak does not count",
                            draft.model.parts[static_cast<std::size_t>(part)].id));
            break;
        }
    if (bag.cv == 0.0 || cards.more()) {
        Card c = cards.next("LOU TEXT A B MW GASC - -");
        bag.exit_rate = c.row_or_none("LOU", draft.curves);
        if (bag.cv == 0.0)
            molar_heat_capacities(c, bag);
        else
            c.harmless("TEXT A B MW GASC");
    }
    keep_bag(cards, draft, std::move(bag));
}

}  // namespace corpuscle::io::keywords
