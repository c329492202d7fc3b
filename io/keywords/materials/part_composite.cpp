// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// *PART_COMPOSITE: layers of one material, which as a membrane are one sheet as thick as all.

#include <fmt/format.h>

#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {
namespace {

/// What layers so far are.
struct Layers {
    Index material = -1;
    double thickness = 0.0;
    int count = 0;
};

bool has_directions(const Draft& draft, Index material) {
    return material >= 0 && std::holds_alternative<fabric::FabricCard>(
                                draft.model.materials[static_cast<std::size_t>(material)].card);
}

void add_layer(Card& c, const Draft& draft, const char* mid, const char* thick, const char* angle,
               Layers& layers) {
    if (!c.given(mid) || c.integer(mid) == 0) {
        c.harmless(thick), c.harmless(angle);
        return;
    }
    const Index material = c.row(mid, draft.materials);
    if (layers.count++ == 0) layers.material = material;
    if (material != layers.material && material >= 0 && layers.material >= 0)
        c.fault(mid,
                fmt::format("{}, the material of the first layer: layers of several materials "
                            "are not acted on yet",
                            draft.model.materials[static_cast<std::size_t>(layers.material)].id));
    layers.thickness += c.real(thick, POSITIVE);
    if (c.real(angle) != 0.0 && has_directions(draft, material))
        c.fault(angle, "0: an angle of a layer is not acted on yet (BETA of *MAT_FABRIC is)");
}

/// MID THICK B TMID, twice a line, to the end of the keyword.
Layers layers_of(Cards& cards, const Draft& draft) {
    static const Layout layout("MID1 THICK1 B1 TMID1 MID2 THICK2 B2 TMID2");
    Layers layers;
    while (cards.rows()) {
        Card c = cards.next(layout);
        add_layer(c, draft, "MID1", "THICK1", "B1", layers);
        add_layer(c, draft, "MID2", "THICK2", "B2", layers);
        c.harmless("TMID1 TMID2");
    }
    return layers;
}

}  // namespace

void part_composite(Cards& cards, Draft& draft) {
    Part part;
    part.title = cards.title();
    Section section;
    section.is_composite = true;
    {
        Card c = cards.next("PID ELFORM=2 SHRF NLOC MAREA HGID ADPOPT THSHEL");
        part.id = c.new_id("PID", draft.parts, draft.model.parts.size());
        section.element_form = c.integer("ELFORM");
        c.harmless("SHRF HGID ADPOPT THSHEL");
        section.place = c.place();
    }
    const Layers layers = layers_of(cards, draft);
    if (layers.count == 0) cards.fault("has no layers, expected rows of MID, THICK and B");
    section.thickness = layers.thickness;
    part.thickness = section.thickness;
    part.element_form = section.element_form;
    part.material = layers.material;
    draft.part_has_solids.push_back(0);
    draft.part_section.push_back(static_cast<Index>(draft.section.size()));
    draft.section.push_back(section);
    draft.model.parts.push_back(part);
}

}  // namespace corpuscle::io::keywords
