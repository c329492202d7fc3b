// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
//
// Elements that join two nodes. Rigid beams become bodies; others are left out, if they hold no
// cloth (loose_ends.cpp).

#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {
namespace {

/// EID PID N1 N2 on the first line, `more` lines behind it.
void link(Cards& cards, Draft& draft, const Layout& layout, std::size_t more) {
    static const Layout rest("- - - - - - - -");
    while (cards.rows()) {
        Link link;
        link.keyword = cards.block().keyword;
        {
            Card c = cards.next(layout);
            link.place = c.place();
            c.integer(std::size_t{0}, {1.0});
            link.part = c.row(std::size_t{1}, draft.parts);
            link.nodes = {c.row(std::size_t{2}, draft.nodes), c.row(std::size_t{3}, draft.nodes)};
            c.harmless_all();
            if (c.good()) draft.links.push_back(std::move(link));
        }
        for (std::size_t i = 0; i < more; ++i) cards.next(rest).harmless_all();
    }
}

}  // namespace

void element_beam(Cards& cards, Draft& draft) {
    static const Layout layout("EID:8 PID:8 N1:8 N2:8 N3:8 RT1:8 RR1:8 RT2:8 RR2:8 LOCAL:8");
    std::size_t more = 0;
    for (const char* option :
         {"THICKNESS", "SECTION", "SCALAR", "SCALR", "PID", "OFFSET", "ORIENTATION", "WARPAGE"})
        more += cards.has(option) ? 1 : 0;
    link(cards, draft, layout, more);
}

void element_discrete(Cards& cards, Draft& draft) {
    static const Layout layout("EID:8 PID:8 N1:8 N2:8 VID:8 S:16 PF:8 OFFSET:16");
    link(cards, draft, layout, 0);
}

void element_seatbelt(Cards& cards, Draft& draft) {
    static const Layout layout("EID:8 PID:8 N1:8 N2:8 SBRID:8 SLEN:16 N3:8 N4:8");
    link(cards, draft, layout, 0);
}

/// Of belts alone, which are no more than links.
void belt_device(Cards& cards, Draft&) {
    cards.warn("is left out, as belts are: nothing pulls or locks");
    cards.abandon();
}

/// Measures, and may weigh something; what refers to it is not read.
void accelerometer(Cards& cards, Draft&) {
    while (cards.rows())
        cards.next("SBACID NID1 NID2 NID3 IGRAV INTOPT MASS")
            .harmless("SBACID NID1 NID2 NID3 IGRAV INTOPT");
    cards.note("is not written: nothing that is read refers to it");
}

/// CNTLID TYPE, and what else it says: of belts, which are left out, or a fault.
void sensor_control(Cards& cards, Draft&) {
    if (cards.has("TITLE")) cards.title();
    bool is_of_belt = false;
    {
        Card c = cards.next("CNTLID TYPE TYPEID TIMEOFF NREP ESTYP - -");
        is_of_belt = upper(c.text("TYPE")).starts_with("BELT");
        c.harmless_all();
        if (!is_of_belt)
            c.fault("TYPE", "that of a belt (BELTPRET ...): sensors switch nothing here");
    }
    if (is_of_belt) cards.note("is not used: belts are left out");
    cards.abandon();
}

}  // namespace corpuscle::io::keywords
