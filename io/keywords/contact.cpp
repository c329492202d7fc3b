// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

constexpr const char* ONE_METHOD = "there is one contact method here, this choice does not count";

/// SURFATYP 2 part set, 3 part, 5 or SURFA = 0 all, 6 all but a part set.
std::vector<Index> surface_parts(Card& c, const Draft& draft) {
    std::vector<Index> all(draft.model.parts.size());
    std::iota(all.begin(), all.end(), 0);
    const bool is_named = c.given("SURFA") && c.integer("SURFA") != 0;
    const int type = is_named ? c.choice("SURFATYP", {2, 3, 5, 6}, {0, 1, 4})
                              : c.integer("SURFATYP", within(0, 6));
    if (!is_named || type == 5 || !c.good()) return all;
    const Index row = c.row("SURFA", type == 3 ? draft.parts : draft.part_sets);
    if (row < 0) return all;
    if (type == 3) return {row};
    const std::vector<Index>& set = draft.part_set[static_cast<std::size_t>(row)];
    if (type == 2) return set;
    std::erase_if(all, [&](Index p) { return std::find(set.begin(), set.end(), p) != set.end(); });
    return all;
}

void surfaces(Cards& cards, const Draft& draft, contact::ContactCard& contact) {
    Card c = cards.next("SURFA SURFB SURFATYP SURFBTYP SABOXID SBBOXID SAPR SBPR");
    contact.parts = surface_parts(c, draft);
    c.harmless("SURFB SURFBTYP SAPR SBPR");  // a single surface; forces are always written
}

void friction(Cards& cards, contact::ContactCard& contact) {
    Card c = cards.next("FS FD DC VC VDC PENCHK BT DT=1e20");
    contact.friction_static = c.real("FS", NON_NEGATIVE);
    contact.friction_dynamic = c.real("FD", NON_NEGATIVE);
    contact.friction_decay = c.real("DC", NON_NEGATIVE);
    contact.damping = c.real("VDC", NON_NEGATIVE);
    contact.birth = c.real("BT", NON_NEGATIVE);
    contact.death = c.real("DT", POSITIVE);
    c.harmless("PENCHK");
}

void thickness(Cards& cards, contact::ContactCard& contact) {
    Card c = cards.next("SFSA=1 SFSB=1 SAST SBST SFSAT=1 SFSBT=1 FSF=1 VSF=1");
    const double t = c.real("SAST", NON_NEGATIVE);
    if (t > 0.0) contact.thickness = t;
    c.noted("SFSA", ONE_METHOD);
    c.harmless("SFSB SBST SFSBT VSF");
}

/// Cards A to G, each needed by those behind it.
void options(Cards& cards, const Draft& draft, contact::ContactCard& contact) {
    if (!cards.more()) return;
    {
        Card c = cards.next("SOFT SOFSCL=0.1 LCIDAB MAXPAR=1.025 SBOPT=2 DEPTH=2 BSORT FRCFRQ=1");
        contact.thickness_curve = c.row_or_none("LCIDAB", draft.curves);
        c.noted("SOFT DEPTH SBOPT", ONE_METHOD);
        c.harmless("SOFSCL MAXPAR BSORT FRCFRQ");
    }
    for (const char* layout : {"PENMAX THKOPT SHLTHK SNLOG ISYM I2D3D SLDTHK SLDSTF",
                               "IGAP=1 IGNORE DPRFAC DTSTIF EDGEK - FLANGL CID_RCF",
                               "Q2TRI DTPCHK SFNBR FNLSCL DNLSCL TCSO TIEDID SHLEDG",
                               "SHAREC CPARM8 IPBACK SRNDE FRICSF ICOR FTORQ REGION",
                               "PSTIFF IGNROFF - FSTOL 2DBINR SSFTYP SWTPR TETFAC", "- SHLOFF"}) {
        if (!cards.more()) return;
        cards.next(layout).harmless_all();
    }
}

}  // namespace

void contact_single_surface(Cards& cards, Draft& draft) {
    contact::ContactCard contact;
    contact.id = static_cast<int>(draft.model.contacts.size()) + 1;
    if (cards.has("ID") || cards.has("TITLE")) {
        Card c = cards.next("CID TITLE:70");
        contact.id = c.integer("CID", {1.0});
        contact.title = c.text("TITLE");
    }
    if (cards.has("MPP")) {
        cards.next("IGNORE BCKET LCBCKT NS2TRK INITITR PARMAX - CPARM8").harmless_all();
        if (cards.starts_with('&')) cards.title();
    }
    surfaces(cards, draft, contact);
    friction(cards, contact);
    thickness(cards, contact);
    options(cards, draft, contact);
    for (const contact::ContactCard& other : draft.model.contacts)
        if (other.id == contact.id)
            cards.fault(fmt::format("has id {}, as another contact has", contact.id));
    draft.model.contacts.push_back(std::move(contact));
}

}  // namespace corpuscle::io::keywords
