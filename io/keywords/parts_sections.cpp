// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "io/keywords/keywords.hpp"
#include "io/keywords/rigid_parts.hpp"

namespace corpuscle::io::keywords {

void section_shell(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Section section;
        {
            Card c = cards.next("SECID ELFORM=2 SHRF NIP PROPT QR ICOMP SETYP=1");
            c.new_id("SECID", draft.sections, draft.section.size());
            section.element_form = c.integer("ELFORM", NON_NEGATIVE);
            c.harmless("SHRF NIP PROPT QR");
            const int form = section.element_form;
            const bool is_plane =
                (form >= 12 && form <= 15) || form > 40 || form == 23 || form == 24;
            if (is_plane)
                c.fault("ELFORM", "a membrane, 5 or 9, or a thin shell of 3 or 4 nodes");
            else if (form != 5 && form != 9)
                c.warn("ELFORM",
                       "this shell is taken as a membrane: only a coat bends (ECOAT, TCOAT of "
                       "*MAT_FABRIC)");
        }
        Card c = cards.next("T1 T2 T3 T4 NLOC MAREA IDOF EDGSET");
        const double first = c.real("T1", POSITIVE);
        section.thickness = first;
        for (const char* corner : {"T2", "T3", "T4"}) {
            const double t = c.real(corner, NON_NEGATIVE);
            section.thickness += t == 0.0 ? first : t;
        }
        section.thickness /= 4.0;
        c.harmless("IDOF EDGSET");
        draft.section.push_back(section);
    }
}

void part(Cards& cards, Draft& draft) {
    while (cards.more()) {
        Part part;
        const auto row = static_cast<Index>(draft.model.parts.size());
        part.title = cards.title();
        {
            Card c = cards.next("PID SECID MID EOSID HGID GRAV ADPOPT TMID");
            part.id = c.new_id("PID", draft.parts, draft.model.parts.size());
            const Index section = c.row("SECID", draft.sections);
            part.material = c.row("MID", draft.materials);
            c.harmless("EOSID HGID GRAV ADPOPT TMID");
            bool has_solids = false;
            if (section >= 0) {
                const Section& s = draft.section[static_cast<std::size_t>(section)];
                part.thickness = s.thickness;
                part.element_form = s.element_form;
                has_solids = s.is_solid;
            }
            draft.part_has_solids.push_back(has_solids ? 1 : 0);
            draft.model.parts.push_back(part);
            const bool rigid = is_rigid(draft, row);
            if (part.material >= 0 && has_solids && !rigid)
                c.fault("SECID", "a *SECTION_SHELL: solids are read for *MAT_RIGID only");
            if (part.material >= 0 && cards.has("INERTIA") && !rigid)
                c.fault("MID", "a *MAT_RIGID, for _INERTIA is of rigid parts");
        }
        if (cards.has("INERTIA")) part_inertia(cards, draft, row);
        if (cards.has("CONTACT")) {
            Card c = cards.next("FS FD DC VC OPTT SFT=1 SSF=1 CPARM8");
            if (const double t = c.real("OPTT", NON_NEGATIVE); t > 0.0)
                draft.model.parts.back().contact_thickness = t;
        }
    }
}

}  // namespace corpuscle::io::keywords
