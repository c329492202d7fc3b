// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/airbag/airbag_vents.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

constexpr const char* BELOW_0 = "gas at rest begins to move along the fabric, by its heat";

bool holds(const std::vector<Index>& parts, Index part) {
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Factors and flags that the NVENT row and *DEFINE_CPM_VENT share. C23 is read by the caller.
void vent_fields(Card& c, const Draft& draft, gas::VentCard& vent) {
    vent.time_curve = c.row_or_none("LCTC23", draft.curves);
    vent.pressure_curve = c.row_or_none("LCPC23", draft.curves);
    vent.is_isentropic = c.choice("ENH_V", {0, 1, 2}) != 0;
    vent.opens_at = c.real("PPOP", NON_NEGATIVE);
}

/// The row of the *DEFINE_CPM_VENT that C23 < 0 names.
const gas::VentCard* defined_vent(Card& c, const Draft& draft, double C23) {
    const Registry::Entry* entry = c.named("C23", -C23, draft.cpm_vents);
    if (entry != nullptr) return &draft.cpm_vent[static_cast<std::size_t>(entry->row)];
    c.fault("C23", ">= 0, or minus the id of a *DEFINE_CPM_VENT of the deck");
    return nullptr;
}

/// What an NPDATA row and *DEFINE_CPM_NPDATA share.
PartExchange exchange(Card& c, const Draft& draft) {
    PartExchange of;
    value_or_curve(c, "HCONV", draft.curves, of.heat.coefficient, of.heat.curve);
    of.is_rough = friction(c, "PFRIC", draft, of.friction);
    return of;
}

/// The *DEFINE_CPM_NPDATA that HCONV names.
PartExchange defined_exchange(Card& c, const Draft& draft) {
    c.harmless("PFRIC SDFBLK KP INIP CP");  // those of *DEFINE_CPM_NPDATA count
    const Registry::Entry* entry = c.named("HCONV", c.real("HCONV"), draft.cpm_npdata);
    if (entry != nullptr) return draft.cpm_exchange[static_cast<std::size_t>(entry->row)];
    c.fault("HCONV", "the id of a *DEFINE_CPM_NPDATA of the deck, with STYPEH 2 and 3");
    return {};
}

}  // namespace

void vent(Cards& cards, const Draft& draft, gas::BagCard& bag) {
    Card c = cards.next("SID3 STYPE3 C23=1 LCTC23 LCPC23 ENH_V PPOP");
    const int type = c.choice("STYPE3", {0, 1, 2});
    const Index row = c.row("SID3", type == 0 ? draft.parts : draft.part_sets);
    gas::VentCard vent;
    vent.coefficient = c.real("C23");
    if (vent.coefficient < 0.0) {
        if (const gas::VentCard* defined = defined_vent(c, draft, vent.coefficient))
            vent = *defined;
        c.harmless("LCTC23 LCPC23 ENH_V PPOP");  // those of *DEFINE_CPM_VENT count
    } else {
        vent_fields(c, draft, vent);
    }
    if (row < 0) return;
    const std::vector<Index> parts =
        type == 0 ? std::vector<Index>{row} : draft.part_set[static_cast<std::size_t>(row)];
    bool has_external = false, has_internal = false;
    for (const Index part : parts) {
        has_external |= holds(bag.external_parts, part);
        has_internal |= holds(bag.internal_parts, part);
        if (!holds(bag.external_parts, part) && !holds(bag.internal_parts, part))
            c.fault("SID3", fmt::format("parts of the bag; part {} is none",
                                        draft.model.parts[static_cast<std::size_t>(part)].id));
    }
    if (has_internal && has_external && vent.is_isentropic && c.good())
        c.fault("ENH_V", "0, or a set of only external or only internal parts");
    if (has_internal && vent.is_isentropic)
        c.warn("ENH_V", "a vent of internal parts passes gas both ways, as fast as the gas flows");
    if (has_internal) vent.is_isentropic = false;
    if (has_internal && has_external && type == 2)
        c.fault("SID3", "external parts or internal ones, not both in one vent");
    for (const Index part : parts) {
        if (type == 2) break;
        bag.vents.push_back(vent);
        bag.vents.back().parts = {part};
    }
    if (type != 2) return;
    vent.parts = parts;
    bag.vents.push_back(vent);
}

void define_cpm_vent(Cards& cards, Draft& draft) {
    gas::VentCard vent;
    if (cards.has("TITLE")) cards.title();
    {
        Card c = cards.next("ID C23=1 LCTC23 LCPC23 ENH_V PPOP C23UP=1 IOPT");
        c.new_id("ID", draft.cpm_vents, draft.cpm_vent.size());
        vent.coefficient = c.real("C23", NON_NEGATIVE);
        vent_fields(c, draft, vent);
        vent.uniform_factor = c.real("C23UP", NON_NEGATIVE);
    }
    // Of the other cards nothing is acted on: what is set there is a fault that says so.
    if (cards.more()) cards.next("JT IDS1 IDS2 IOPT1 PID1 PID2 VANG LCRED");
    if (cards.more()) cards.next("NID1 NID2 NID3 LCAC23 PSETPV SFPV LPATM IBLKOF");
    if (cards.more()) cards.next("JTND");
    draft.cpm_vent.push_back(vent);
}

void define_cpm_npdata(Cards& cards, Draft& draft) {
    if (cards.has("TITLE")) cards.title();
    {
        Card c = cards.next("ID HCONV PFRIC SDFBLK=1 KP INIP CP PSFDCF");
        c.new_id("ID", draft.cpm_npdata, draft.cpm_exchange.size());
        draft.cpm_exchange.push_back(exchange(c, draft));
    }
    if (cards.more()) cards.next("HCINT CDEXT");
}

void part_data(Cards& cards, const Draft& draft, gas::BagCard& bag) {
    Card c = cards.next("SIDH STYPEH HCONV PFRIC SDFBLK=1 KP INIP CP");
    const int type = c.choice("STYPEH", {0, 1, 2, 3});
    const bool is_part = type == 0 || type == 2;
    const Index row = c.row("SIDH", is_part ? draft.parts : draft.part_sets);
    auto [heat, rough, is_rough] = type < 2 ? exchange(c, draft) : defined_exchange(c, draft);
    if (row < 0) return;
    heat.parts = rough.parts =
        is_part ? std::vector<Index>{row} : draft.part_set[static_cast<std::size_t>(row)];
    for (const Index part : heat.parts)
        if (!holds(bag.external_parts, part) && !holds(bag.internal_parts, part))
            c.fault("SIDH", fmt::format("parts of the bag; part {} is none",
                                        draft.model.parts[static_cast<std::size_t>(part)].id));
    if (heat.coefficient != 0.0 || heat.curve >= 0) bag.heat.push_back(heat);
    if (is_rough) bag.friction.push_back(rough);
}

bool friction(Card& c, const char* name, const Draft& draft, gas::FrictionCard& rough) {
    const double value = c.real(name);
    if (value == 0.0 || !c.good()) return false;
    if (value > 1.0) {
        c.fault(name, "above -1 to 1, or minus the id of a *DEFINE_CURVE: no *DEFINE_FUNCTION");
        return false;
    }
    if (value > -1.0) {
        if (value < 0.0) c.warn(name, fmt::format("below 0: {}", BELOW_0));
        rough.factor = value;
        return true;
    }
    double unused = 0.0;
    value_or_curve(c, name, draft.curves, unused, rough.curve);
    if (rough.curve < 0) return false;
    const std::vector<double>& factors =
        draft.model.curves[static_cast<std::size_t>(rough.curve)].y;
    if (factors.empty()) return false;  // a curve with faults
    const auto [least, most] = std::minmax_element(factors.begin(), factors.end());
    if (!(*least > -1.0 && *most <= 1.0)) {
        c.fault(name, "a curve of factors above -1 and up to 1");
        return false;
    }
    if (*least < 0.0) c.warn(name, fmt::format("a curve down to {:g}: {}", *least, BELOW_0));
    return true;
}

void block(Card& c, gas::BagCard& bag) {
    const int code = c.choice("BLOCK", {0, 1, 2, 3, 4, 10, 11, 12, 13, 14, 20, 21, 22, 23, 24});
    const int by_contact = code % 10, escaped = code / 10;
    bag.block.fabric = by_contact >= 1;
    bag.block.external_vents = by_contact == 1 || by_contact == 3;
    bag.block.internal_vents = by_contact == 1 || by_contact == 2;
    bag.block.by_pressure = escaped == 2;
    if (escaped == 1)
        c.warn("BLOCK",
               "no particle escapes here: a bag with holes that are not meshed is refused");
}

void check_leaks(Cards& cards, const Draft& draft, const gas::BagCard& bag) {
    std::vector<Index> parts = bag.external_parts;
    parts.insert(parts.end(), bag.internal_parts.begin(), bag.internal_parts.end());
    for (const Index row : parts) {
        const Part& part = draft.model.parts[static_cast<std::size_t>(row)];
        if (part.material < 0) continue;
        const auto& material = draft.model.materials[static_cast<std::size_t>(part.material)];
        const fabric::FabricCard* cloth = leakage_of(draft.model, row);
        if (cloth == nullptr) continue;
        const std::string who =
            fmt::format("part {} \"{}\": its material {} leaks", part.id, part.title, material.id);
        const int option = cloth->leak_option;
        if (cloth->leak_growth) {
            if (option < 0 || option > 2)
                cards.fault(
                    fmt::format("{} through X0 to X3 with FVOPT = {}, expected 0, 1 or 2: "
                                "an orifice of that area",
                                who, option));
            if ((*cloth->leak_growth)[0] < 0.0)
                cards.fault(
                    fmt::format("{} with X0 = {:g}, expected >= 0: the compression seal is "
                                "not acted on yet",
                                who, (*cloth->leak_growth)[0]));
            if (holds(bag.internal_parts, row))
                cards.fault(who + " through X0 to X3 but is internal, expected FLC and FAC");
        } else if (option < 0) {
            cards.fault(
                fmt::format("{} with FVOPT = {}, expected 0 to 8: the area of single "
                            "yarns' gaps is not acted on yet",
                            who, option));
        } else if (option >= 1 && option <= 6 && holds(bag.internal_parts, row)) {
            cards.fault(
                fmt::format("{} with FVOPT = {} but is internal, expected 7 or 8", who, option));
        } else if (option == 0) {
            cards.warn(who + " (FLC, FAC) with FVOPT blank: 7 is taken, FAC is a velocity");
        }
    }
}

}  // namespace corpuscle::io::keywords
