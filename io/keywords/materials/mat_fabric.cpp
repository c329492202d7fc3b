// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "fabric/materials/law.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

void value_or_curve(Card& c, const char* name, const Registry& curves, double& value,
                    Index& curve) {
    value = c.real(name);
    if (!c.good() || value >= 0.0) return;
    const Registry::Entry* entry = c.named(name, -value, curves);
    value = 0.0;
    if (entry == nullptr)
        return c.fault(name, ">= 0, or minus the id of a *DEFINE_CURVE of the deck");
    curve = entry->row;
}

namespace {

using fabric::FabricCard;

/// EB = 0 means isotropic: G = EA / 2(1 + PRBA).
void elasticity(Cards& cards, Draft& draft, fabric::Material& material, FabricCard& cloth) {
    Card c = cards.next("MID RO EA EB EC PRBA PRAB PRCB");
    material.id = c.new_id("MID", draft.materials, draft.model.materials.size());
    cloth.density = c.real("RO", POSITIVE);
    cloth.E_warp = c.real("EA", POSITIVE);
    cloth.E_weft = c.real("EB", NON_NEGATIVE);
    cloth.nu_ba = c.real("PRBA", {-1.0, 1.0, true, true});
    c.harmless("EC PRAB PRCB");  // spare fields of old decks; PRAB follows from symmetry
    const bool isotropic = cloth.E_weft == 0.0;
    if (isotropic) cloth.E_weft = cloth.E_warp;
    if (c.good() && cloth.nu_ba * cloth.nu_ba * cloth.E_warp / cloth.E_weft >= 1.0)
        c.fault("PRBA", "PRBA^2 EA / EB < 1");

    Card d = cards.next("GAB GBC GCA CSE EL PRL LRATIO DAMP");
    cloth.G = d.real("GAB", NON_NEGATIVE);
    if (isotropic)
        cloth.G = cloth.E_warp / (2.0 * (1.0 + cloth.nu_ba));
    else if (d.good() && cloth.G == 0.0)
        d.fault("GAB", "> 0, for EB is given");
    cloth.no_compression = d.choice("CSE", {0, 1}) == 1;
    cloth.liner_E = d.real("EL", NON_NEGATIVE);
    cloth.liner_nu = d.real("PRL", {-1.0, 0.5, true});
    cloth.liner_ratio = d.real("LRATIO", NON_NEGATIVE);
    cloth.damping = d.real("DAMP", NON_NEGATIVE);
    d.harmless("GBC GCA");
}

/// -14 is 14 with the card of the coat, which is read behind 4 and 14 too where it is there.
void fabric_form(Card& c, FabricCard& cloth) {
    cloth.form = std::abs(c.choice("FORM", {0, 1, 2, 3, 4, 12, 13, 14, -14}, {24}));
    if (cloth.form == 12)
        c.warn("FORM", "the refined form 2: taken as 2, linear in the Green-Lagrange strain");
    if (cloth.form == 3 || cloth.form == 13)
        c.warn("FORM",
               "yarns that do not stay at right angles: taken as form 2, linear in the "
               "Green-Lagrange strain along the yarns as they turn");
}

/// TSRFAC: a share in every step, a curve of it, or a curve of what has come back.
void restoration(Card& c, Draft& draft, FabricCard& cloth) {
    const double factor = c.real("TSRFAC");
    if (!c.good() || factor == 0.0) return;
    fabric::StrainRestoration& how = cloth.restoration;
    if (factor > 0.0 && factor < 1.0) {
        how.share = factor;
        return;
    }
    if (factor > 0.0 && cloth.form < 2)
        return c.fault("TSRFAC", "below 1 for FORM 0 and 1, which have no course over time");
    const Registry::Entry* entry = c.named("TSRFAC", std::abs(factor), draft.curves);
    if (entry == nullptr)
        return c.fault("TSRFAC", "0 to 1, or the id of a *DEFINE_CURVE of the deck, or minus it");
    (factor < 0.0 ? how.share_curve : how.course_curve) = entry->row;
    for (const double y : draft.model.curves[static_cast<std::size_t>(entry->row)].y)
        if (!(y >= 0.0 && y <= 1.0)) return c.fault("TSRFAC", "a curve of values from 0 to 1");
}

/// @returns FVOPT < 0: there is another card
bool axes_and_leakage(Cards& cards, Draft& draft, FabricCard& cloth) {
    Card c = cards.next("AOPT FLC FAC ELA LNRC FORM FVOPT TSRFAC");
    cloth.axes = c.choice("AOPT", {0, 2, 3}, {1, 4});
    value_or_curve(c, "FLC", draft.curves, cloth.leak_area, cloth.leak_area_curve);
    value_or_curve(c, "FAC", draft.curves, cloth.leak_velocity, cloth.leak_velocity_curve);
    fabric_form(c, cloth);
    restoration(c, draft, cloth);
    cloth.liner_waits = c.choice("LNRC", {0, 1}, {2}) == 1;
    if (cloth.liner_waits && !(cloth.liner_E > 0.0 && cloth.liner_ratio > 0.0))
        c.warn("LNRC", "there is no liner (EL, LRATIO) that could wait");
    cloth.leak_option = c.integer("FVOPT", within(-8, 8));
    cloth.leak_when_blocked = c.real("ELA", within(0.0, 1.0));
    cloth.leak_by_component = draft.dialect == Dialect::NOTES_2007;
    return cloth.leak_option < 0;
}

/// With X0 the fields FLC and FAC are X2 and X3.
void leak_growth(Card& c, FabricCard& cloth) {
    const double X0 = c.real("X0"), X1 = c.real("X1");
    if (X0 == 0.0) {
        if (X1 != 0.0) c.fault("X1", "0 or blank without X0");
        return;
    }
    if (cloth.leak_area_curve >= 0 || cloth.leak_velocity_curve >= 0)
        c.fault("X0", "0 or blank, or FLC and FAC as numbers: they are X2 and X3 then");
    cloth.leak_growth = {X0, X1, cloth.leak_area, cloth.leak_velocity};
    cloth.leak_area = cloth.leak_velocity = 0.0;
}

/// Forms 4 and 14 may have curves; old decks print the card, empty, for every form.
void stress_curves(Cards& cards, Draft& draft, FabricCard& cloth) {
    if (!cards.more()) return;
    Card c = cards.next("LCA LCB LCAB LCUA LCUB LCUAB RL -");
    if (cloth.form != 4 && cloth.form != 14) return;
    const char* fields[] = {"LCA", "LCB", "LCAB", "LCUA", "LCUB", "LCUAB"};
    for (std::size_t i = 0; i < 3; ++i) {
        cloth.curves.load[i] = c.row_or_none(fields[i], draft.curves);
        cloth.curves.unload[i] = c.row_or_none(fields[i + 3], draft.curves);
    }
    if (cloth.form == 14) cloth.curves.reload = c.real("RL", within(0.0, 1.0));
    if (!c.good()) return;
    for (const fabric::CurveFault& fault : fabric::curve_faults(cloth, draft.model.curves))
        c.fault(fields[fault.direction + (fault.unloads ? 3 : 0)], fault.expected);
    if (cloth.curves.any() && cloth.nu_ba != 0.0)
        c.warn("LCA", "with curves warp and weft do not feel each other: PRBA does not count");
}

/// The card that FORM -14 has behind the curves, and that 4 and 14 may have: for the coat alone.
void coat(Cards& cards, FabricCard& cloth) {
    if ((cloth.form != 4 && cloth.form != 14) || !cards.more()) return;
    Card c = cards.next("LCAA LCBB H DT - ECOAT SCOAT TCOAT");
    cloth.coat_E = c.real("ECOAT", NON_NEGATIVE);
    const double thickness = c.real("TCOAT");
    if (!c.good()) return;
    if (cloth.coat_E > 0.0 && thickness == 0.0) c.fault("TCOAT", "a thickness, for ECOAT is given");
    if (cloth.coat_E == 0.0 && thickness != 0.0) c.fault("ECOAT", "> 0, for TCOAT is given");
    cloth.coat_thickness = std::abs(thickness);
    cloth.coat_stretches = thickness > 0.0;
}

void directions(Cards& cards, FabricCard& cloth) {
    {
        Card c = cards.next("- RGBRTH A0REF A1 A2 A3 X0 X1");
        cloth.a = c.direction("A1", "A2", "A3");
        cloth.reference_birth = c.real("RGBRTH", NON_NEGATIVE);
        if (cloth.reference_birth > 0.0 && cloth.restoration.any())
            c.fault("RGBRTH", "0 or blank: with TSRFAC strains come back from the start on");
        cloth.leak_from_reference = c.choice("A0REF", {0, 1}) == 1;
        leak_growth(c, cloth);
        if (cloth.axes == 2 && c.good() && cloth.a.isZero(0.0))
            c.fault("A1", "a vector for AOPT = 2");
    }
    Card c = cards.next("V1 V2 V3 D1 D2 D3 BETA ISREFG");
    cloth.v = c.direction("V1", "V2", "V3");
    if (cloth.axes == 3 && c.good() && cloth.v.isZero(0.0)) c.fault("V1", "a vector for AOPT = 3");
    cloth.beta = c.real("BETA") * std::numbers::pi / 180.0;
    if (c.file().mirrors()) cloth.beta = -cloth.beta;  // about normals that are mirrored too
    c.harmless("D1 D2 D3 ISREFG");  // stress counts from the reference shape anyway
}

}  // namespace

void mat_fabric(Cards& cards, Draft& draft) {
    fabric::Material material;
    if (cards.has("TITLE")) material.title = cards.title();
    FabricCard cloth;
    elasticity(cards, draft, material, cloth);
    if (axes_and_leakage(cards, draft, cloth)) cards.next("L R C1 C2 C3").harmless("L R C1 C2 C3");
    directions(cards, cloth);
    stress_curves(cards, draft, cloth);
    coat(cards, cloth);
    if ((cloth.form == 4 || cloth.form == 14) && !cloth.curves.any())
        cards.warn(
            "has no load curves: it is linear in the Green-Lagrange strain of warp and weft");
    material.card = cloth;
    draft.model.materials.push_back(material);
}

}  // namespace corpuscle::io::keywords
