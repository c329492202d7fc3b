// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *DEFORMABLE_TO_RIGID: parts that are rigid from the start, with the mass of their material.

#include <algorithm>

#include "fabric/materials/law.hpp"
#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {
namespace {

/// A rigid material of the same density, which leaks as the part's own does, for this part alone.
void make_rigid(Card& c, Draft& draft, Index part) {
    Model& model = draft.model;
    Index& row = model.parts[static_cast<std::size_t>(part)].material;
    if (row < 0) return c.fault("PID", "a part with a material");
    const fabric::Material own = model.materials[static_cast<std::size_t>(row)];
    fabric::RigidCard rigid;
    rigid.density = fabric::density(own.card);
    rigid.E = 1.0;
    const auto unread = draft.unread_materials.find(row);
    if (unread != draft.unread_materials.end()) rigid.density = unread->second.density;
    if (!(rigid.density > 0.0)) return c.fault("PID", "a part whose material has a density RO > 0");
    const Index before = row;
    row = static_cast<Index>(model.materials.size());
    model.materials.push_back({own.id, own.title, rigid});
    const auto added = std::find_if(model.added_leaks.begin(), model.added_leaks.end(),
                                    [&](const AddedLeak& leak) { return leak.material == before; });
    const auto* cloth = std::get_if<fabric::FabricCard>(&own.card);
    if (added != model.added_leaks.end())
        model.added_leaks.push_back({row, fabric::FabricCard(added->says)});
    else if (cloth != nullptr && cloth->leaks())
        model.added_leaks.push_back({row, *cloth});
    const bool is_left = std::none_of(model.parts.begin(), model.parts.end(),
                                      [&](const Part& p) { return p.material == before; });
    for (auto& [material, place] : draft.added_leaks)
        if (material == before && is_left) material = row;
}

/// LRB: the part goes with that one, whose body has the mass of both.
void merge(Card& c, Draft& draft, Index part) {
    const Index lead = c.row_or_none("LRB", draft.parts);
    if (lead < 0) return;
    if (lead == part || lead_of(draft, lead) == part)
        c.fault("LRB", "a part that PID does not lead");
    else if (!is_rigid(draft, lead))
        c.fault("LRB", "a part with *MAT_RIGID, or one of a row above");
    else if (lead_of(draft, part) != part)
        c.fault("PID", "a part that no other leads yet");
    else
        draft.model.rigid_merges.push_back({lead, part, false});
}

}  // namespace

void deformable_to_rigid(Cards& cards, Draft& draft) {
    static const Layout layout("PID LRB PTYPE");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const std::string type = c.given("PTYPE") ? upper(c.text("PTYPE")) : "PART";
        if (type != "PART") {
            c.fault("PTYPE", type == "PSET" ? "PART: a row for each part of the set" : "PART");
            c.harmless_all();
            continue;
        }
        const Index part = c.row("PID", draft.parts);
        if (part >= 0 && !is_rigid(draft, part)) make_rigid(c, draft, part);
        if (c.good()) merge(c, draft, part);
        c.harmless("LRB");  // of a row that is refused
    }
}

}  // namespace corpuscle::io::keywords
