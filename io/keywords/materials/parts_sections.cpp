// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <numbers>

#include "fabric/materials/law.hpp"
#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

constexpr double MOST_POINTS = 1000.0;  ///< through the thickness

/// T1 to T4; those that are blank are T1.
double mean_thickness(Cards& cards) {
    Card c = cards.next("T1 T2 T3 T4 NLOC MAREA IDOF EDGSET");
    const double first = c.real("T1", POSITIVE);
    double sum = first;
    for (const char* corner : {"T2", "T3", "T4"}) {
        const double t = c.real(corner, NON_NEGATIVE);
        sum += t == 0.0 ? first : t;
    }
    c.harmless("IDOF EDGSET");
    return sum / 4.0;
}

/// ICOMP = 1: an angle for each point through the thickness, eight on a line; 0 turns nothing.
void blank_angles(Cards& cards, int points) {
    static const Layout layout("B1 B2 B3 B4 B5 B6 B7 B8");
    for (int first = 0; first < points && cards.lines_left() > 0; first += 8) cards.next(layout);
}

/// Cross section, of the forms whose card says it.
void beam_area(Cards& cards, Section& section) {
    switch (section.element_form) {
        case 1:
        case 9:
        case 11: {
            Card c = cards.next("TS1 TS2 TT1 TT2 - -");
            const double outer = c.real("TS1"), inner = c.real("TT1");
            section.area = section.is_tube
                               ? std::numbers::pi / 4.0 * (outer * outer - inner * inner)
                               : outer * inner;
            c.harmless_all();
            return;
        }
        case 2:
        case 3:
        case 12: {
            Card c = cards.next("A - - - - - - -");
            section.area = c.real("A");
            c.harmless_all();
            return;
        }
        default:
            cards.next("- - - - - - - -").harmless_all();
            return;
    }
}

/// A part that nothing is of may lack a section or a material.
void bare_part(Card& c, Draft& draft, Index row, const char* lacks) {
    draft.bare_parts[row] = {lacks, c.place()};
    c.warn(lacks, "a part without it is nothing, as long as no element is of it");
}

/// Solids that deform are taken as rigid: a table to land on, a plate.
void stiffen(Card& c, Draft& draft, Index row) {
    Part& part = draft.model.parts[static_cast<std::size_t>(row)];
    const fabric::Material& own = draft.model.materials[static_cast<std::size_t>(part.material)];
    fabric::RigidCard rigid;
    rigid.density = fabric::density(own.card);
    rigid.E = 1.0;
    if (const auto* elastic = std::get_if<fabric::ElasticCard>(&own.card)) rigid.E = elastic->E;
    const auto unread = draft.unread_materials.find(part.material);
    if (unread != draft.unread_materials.end()) rigid.density = unread->second.density;
    if (!(rigid.density > 0.0)) return c.fault("MID", "a material of solids with a density RO > 0");
    c.warn("SECID",
           "solids that deform are taken as one rigid body, held where a *BOUNDARY_SPC holds a "
           "node of it: what it would give way is lost");
    const fabric::Material stiff{own.id, own.title, rigid};
    part.material = static_cast<Index>(draft.model.materials.size());
    draft.model.materials.push_back(stiff);
    draft.stiffened_parts.push_back(row);
}

}  // namespace

void section_shell(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Section section;
        int points = 1;
        bool has_angles = false;
        {
            Card c = cards.next("SECID ELFORM=2 SHRF NIP=2 PROPT QR ICOMP SETYP=1");
            c.new_id("SECID", draft.sections, draft.section.size());
            section.element_form = c.integer("ELFORM", NON_NEGATIVE);
            const double asked = c.real("NIP", NON_NEGATIVE);
            if (asked > MOST_POINTS) c.fault("NIP", "at most 1000 points through the thickness");
            points = static_cast<int>(std::clamp(asked, 1.0, MOST_POINTS));
            has_angles = c.choice("ICOMP", {0, 1}) == 1;
            c.harmless("SHRF PROPT QR");
            section.place = c.place();
        }
        section.thickness = mean_thickness(cards);
        if (has_angles) blank_angles(cards, points);
        draft.section.push_back(section);
    }
}

void section_other(Cards& cards, Draft& draft) {
    const bool is_beam = cards.block().keyword.starts_with("SECTION_BEAM");
    while (cards.rows()) {
        if (cards.has("TITLE")) cards.title();
        Section section;
        section.other = cards.block().keyword;
        {
            Card c = cards.next("SECID ELFORM=1 - - CST - - -");
            c.new_id("SECID", draft.sections, draft.section.size());
            if (is_beam) section.element_form = c.integer("ELFORM");
            section.is_tube = is_beam && c.real("CST") == 1.0;
            c.harmless_all();
        }
        if (is_beam)
            beam_area(cards, section);
        else
            cards.abandon();  // of a form that is not read
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
            const Index section = c.row_or_none("SECID", draft.sections);
            part.material = c.row_or_none("MID", draft.materials);
            if (c.good() && (section < 0 || part.material < 0))
                bare_part(c, draft, row, section < 0 ? "SECID" : "MID");
            c.harmless("EOSID HGID GRAV ADPOPT TMID");
            bool has_solids = false;
            if (section >= 0) {
                const Section& s = draft.section[static_cast<std::size_t>(section)];
                part.thickness = s.thickness;
                part.element_form = s.element_form;
                has_solids = s.is_solid;
            }
            draft.part_has_solids.push_back(has_solids ? 1 : 0);
            draft.part_section.push_back(section);
            draft.model.parts.push_back(part);
            const bool rigid = is_rigid(draft, row);
            if (part.material >= 0 && has_solids && !rigid) stiffen(c, draft, row);
            if (part.material >= 0 && cards.has("INERTIA") && !rigid)
                c.fault("MID", "a *MAT_RIGID, for _INERTIA is of rigid parts");
        }
        if (cards.has("INERTIA")) part_inertia(cards, draft, row);
        if (cards.has("CONTACT")) {
            Card c = cards.next("FS FD DC VC OPTT SFT=1 SSF=1 CPARM8");
            if (const double t = c.real("OPTT", NON_NEGATIVE); t > 0.0)
                draft.model.parts.back().contact_thickness = t;
            c.noted("FS FD DC VC",
                    "friction is that of the contact's card: a part's counts with its FS = -1, "
                    "which is refused");
        }
    }
}

}  // namespace corpuscle::io::keywords
