// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

/// *CONSTRAINED_RIGID_BODIES: parts that move as one.
namespace corpuscle::io::keywords {

Index lead_of(const Draft& draft, Index part) {
    for (const RigidMerge& merge : draft.model.rigid_merges)
        if (merge.part == part) return lead_of(draft, merge.lead);
    return part;
}

void expect_lead(Card& c, const Draft& draft, const char* field, Index part) {
    const Index lead = lead_of(draft, part);
    if (lead != part)
        c.fault(field, fmt::format("part {}, which leads the merged body",
                                   draft.model.parts[static_cast<std::size_t>(lead)].id));
}

namespace {

Index rigid_part(Card& c, const Draft& draft, const char* field) {
    const Index part = c.row(field, draft.parts);
    if (part >= 0 && !is_rigid(draft, part)) c.fault(field, "a part with *MAT_RIGID");
    return part;
}

const fabric::RigidCard& card_of(const Draft& draft, Index part) {
    const Model& model = draft.model;
    const Index material = model.parts[static_cast<std::size_t>(part)].material;
    return std::get<fabric::RigidCard>(model.materials[static_cast<std::size_t>(material)].card);
}

/// What would be a second word on how the body moves is refused.
void check_led(Card& c, const Draft& draft, Index lead, Index part) {
    const fabric::RigidCard& own = card_of(draft, part);
    const bool is_held = own.fixed_moves != 0 || own.fixed_turns != 0;
    const bool is_lead_s = draft.model.parts[static_cast<std::size_t>(part)].material ==
                           draft.model.parts[static_cast<std::size_t>(lead)].material;
    if (is_held && !is_lead_s)
        c.fault("PIDC", "a part whose *MAT_RIGID holds nothing: the lead's constraints count");
    const bool starts = std::any_of(draft.inertia_start.begin(), draft.inertia_start.end(),
                                    [&](const RigidVelocity& start) { return start.part == part; });
    if (starts)
        c.fault("PIDC", "a part whose *PART_INERTIA has no velocity: that of the lead counts");
}

}  // namespace

void constrained_rigid_bodies(Cards& cards, Draft& draft) {
    static const Layout layout("PIDL PIDC IFLAG");
    Model& model = draft.model;
    while (cards.rows()) {
        Card c = cards.next(layout);
        RigidMerge merge;
        merge.lead = rigid_part(c, draft, "PIDL");
        merge.part = rigid_part(c, draft, "PIDC");
        const bool updates = c.choice("IFLAG", {0, 1}) == 1;
        if (!c.good()) continue;
        // read before solids become skins: what is here is *PART_INERTIA
        merge.keeps_inertia =
            !updates &&
            std::any_of(model.rigid_inertia.begin(), model.rigid_inertia.end(),
                        [&](const RigidInertia& body) { return body.part == merge.lead; });
        if (lead_of(draft, merge.part) != merge.part)
            c.fault("PIDC", "a part that no other leads yet");
        else if (lead_of(draft, merge.lead) == merge.part)
            c.fault("PIDC", "a part that does not lead PIDL");
        else
            check_led(c, draft, merge.lead, merge.part);
        if (c.good()) model.rigid_merges.push_back(merge);
    }
}

}  // namespace corpuscle::io::keywords
