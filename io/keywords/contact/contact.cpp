// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "io/keywords/contact/contact_surface.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

constexpr const char* ONE_METHOD = "there is one contact method here, this choice does not count";

using Kind = contact::ContactCard::Kind;

/// A single surface has no other side, the kinds with two sides must name both.
void surfaces(Cards& cards, const Draft& draft, contact::ContactCard& contact,
              ContactShells& some) {
    Card c = cards.next("SURFA SURFB SURFATYP SURFBTYP SABOXID SBBOXID SAPR SBPR");
    c.harmless("SAPR SBPR");  // forces are always written
    ContactSide a = contact_side(c, draft, SIDE_A, contact.kind == Kind::NODES_TO_SURFACE);
    keep_in_box(c, draft, "SABOXID", a);
    contact.parts = std::move(a.parts);
    some.first = std::move(a.some_shells);
    if (contact.kind == Kind::SINGLE_SURFACE) return c.harmless("SURFB SURFBTYP");
    ContactSide b = contact_side(c, draft, SIDE_B, /*may_be_nodes=*/false);
    keep_in_box(c, draft, "SBBOXID", b);
    contact.other_parts = std::move(b.parts);
    some.second = std::move(b.some_shells);
    for (const SideFields& side : {SIDE_A, SIDE_B})
        if (c.integer(side.surface) == 0 && c.integer(side.type) != 5)
            c.fault(side.surface, "a part, a set, or type 5 for all parts");
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

/// SAST or SBST; else SFSAT or SFSBT times the shells' own, which must be one for a card that holds
/// one thickness a side.
double side_thickness(Card& c, const Draft& draft, const std::vector<Index>& parts,
                      const char* given, const char* scale) {
    if (const double t = c.real(given, NON_NEGATIVE); t > 0.0) {
        c.harmless(scale);  // of the shells' own
        return t;
    }
    const double factor = c.real(scale, POSITIVE);
    if (factor == 1.0 || !c.good()) return NaN;
    double common = NaN;
    for (const Index part : parts) {
        const Part& p = draft.model.parts[static_cast<std::size_t>(part)];
        const double t = std::isnan(p.contact_thickness) ? p.thickness : p.contact_thickness;
        if (!std::isnan(common) && t != common)
            c.fault(scale, "1, or parts of one thickness on this side");
        common = t;
    }
    return factor * common;
}

void thickness(Cards& cards, const Draft& draft, contact::ContactCard& contact) {
    Card c = cards.next("SFSA=1 SFSB=1 SAST SBST SFSAT=1 SFSBT=1 FSF=1 VSF=1");
    contact.thickness = side_thickness(c, draft, contact.parts, "SAST", "SFSAT");
    if (contact.kind == Kind::SINGLE_SURFACE)
        c.harmless("SBST SFSBT");
    else
        contact.other_thickness = side_thickness(c, draft, contact.other_parts, "SBST", "SFSBT");
    c.noted("SFSA SFSB", ONE_METHOD);
    c.harmless("VSF");                              // of viscous friction, which VC would ask for
    const double factor = c.real("FSF", POSITIVE);  // on Coulomb's friction
    contact.friction_static *= factor;
    contact.friction_dynamic *= factor;
}

/// Cards A to G, each needed by those behind it.
void options(Cards& cards, const Draft& draft, contact::ContactCard& contact) {
    if (!cards.more()) return;
    std::string ignored;
    {
        Card c = cards.next("SOFT SOFSCL=0.1 LCIDAB MAXPAR=1.025 SBOPT=2 DEPTH=2 BSORT FRCFRQ=1");
        contact.thickness_curve = c.row_or_none("LCIDAB", draft.curves);
        if (contact.thickness_curve >= 0)
            for (const double t :
                 draft.model.curves[static_cast<std::size_t>(contact.thickness_curve)].y)
                if (!(t > 0.0)) {
                    c.fault("LCIDAB", "a curve of thicknesses above 0");
                    break;
                }
        c.noted("SOFT DEPTH SBOPT", ONE_METHOD);
        c.harmless("SOFSCL MAXPAR BSORT FRCFRQ");
    }
    for (const char* layout : {"PENMAX THKOPT SHLTHK SNLOG ISYM I2D3D SLDTHK SLDSTF",
                               "IGAP=1 IGNORE DPRFAC DTSTIF EDGEK - FLANGL CID_RCF",
                               "Q2TRI DTPCHK SFNBR FNLSCL DNLSCL TCSO TIEDID SHLEDG",
                               "SHAREC CPARM8 IPBACK SRNDE FRICSF ICOR FTORQ REGION",
                               "PSTIFF IGNROFF - FSTOL 2DBINR SSFTYP SWTPR TETFAC", "- SHLOFF"}) {
        if (!cards.more()) break;
        Card c = cards.next(layout);
        for (const std::string_view name : c.set_fields())
            ignored += fmt::format("{}{}", ignored.empty() ? "" : ", ", name);
        c.harmless_all();
    }
    if (!ignored.empty()) cards.warn(fmt::format("sets {}: {}", ignored, ONE_METHOD));
}

/// What the kinds that are not _AUTOMATIC_ or _AIRBAG_, or that are one-way, become.
void say_kind(Cards& cards) {
    const std::string& keyword = cards.block().keyword;
    const auto has = [&](const char* word) { return keyword.find(word) != std::string::npos; };
    if (has("ONE_WAY"))
        cards.warn(
            "is taken as a two-way contact: nodes and edges of both sides are held, so less "
            "passes through");
    if (has("ERODING"))
        cards.warn("is taken as a contact whose elements stay: nothing erodes here");
    if (has("_RIGID_BODY"))
        cards.warn("stops what meets it exactly: its force over penetration, LCID, does not count");
    if (has("MORTAR") || has("SMOOTH"))
        cards.warn("is taken as the contact that there is, of flat facets, nodes and edges");
    if (!has("AUTOMATIC") && !has("AIRBAG") && !has("_RIGID_BODY"))
        cards.warn("holds facets on both their sides, as _AUTOMATIC_ does: normals do not count");
}

}  // namespace

namespace {

void read_contact(Cards& cards, Draft& draft, Kind kind) {
    contact::ContactCard contact;
    contact.kind = kind;
    if (cards.has("ID") || cards.has("TITLE")) {
        Card c = cards.next("CID TITLE:70");
        contact.id = c.id("CID", IdKind::OTHER, NON_NEGATIVE);
        contact.title = c.text("TITLE");
    }
    if (cards.has("MPP")) {
        cards.next("IGNORE BCKET LCBCKT NS2TRK INITITR PARMAX - CPARM8").harmless_all();
        if (cards.starts_with('&')) cards.title();
    }
    say_kind(cards);
    ContactShells some;
    surfaces(cards, draft, contact, some);
    friction(cards, contact);
    thickness(cards, draft, contact);
    if (cards.block().keyword.starts_with("CONTACT_ERODING"))
        cards.next("ISYM EROSOP IADJ").harmless_all();
    if (cards.block().keyword.starts_with("CONTACT_RIGID"))
        cards.next("LCID FCM DS LCDC DSF UNLCID").harmless_all();
    options(cards, draft, contact);
    for (const contact::ContactCard& other : draft.model.contacts)
        if (contact.id != 0 && other.id == contact.id)
            cards.fault(fmt::format("has id {}, as another contact has", contact.id));
    draft.model.contacts.push_back(std::move(contact));
    draft.model.contact_shells.push_back(std::move(some));
}

}  // namespace

void contact_single_surface(Cards& cards, Draft& draft) {
    read_contact(cards, draft, Kind::SINGLE_SURFACE);
}
void contact_surface_to_surface(Cards& cards, Draft& draft) {
    read_contact(cards, draft, Kind::SURFACE_TO_SURFACE);
}
/// Beams are bodies of thin rods or left out: they have no surface.
void contact_beams(Cards& cards, Draft&) {
    cards.warn("is left out: beams have no surface here, cloth and rigid parts pass through them");
    cards.abandon();
}
void contact_nodes_to_surface(Cards& cards, Draft& draft) {
    read_contact(cards, draft, Kind::NODES_TO_SURFACE);
}

}  // namespace corpuscle::io::keywords
