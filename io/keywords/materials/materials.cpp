// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>

#include "io/keywords/bodies/held.hpp"
#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

constexpr Range POISSON{-1.0, 0.5, true,
                        false};  ///< isotropic, positive energy; 0.5 is a membrane's too

std::string material_title(Cards& cards) {
    return cards.has("TITLE") ? cards.title() : std::string();
}

}  // namespace

void mat_elastic(Cards& cards, Draft& draft) {
    fabric::Material material;
    material.title = material_title(cards);
    Card c = cards.next("MID RO E PR DA DB K -");
    material.id = c.new_id("MID", draft.materials, draft.model.materials.size());
    fabric::ElasticCard elastic;
    elastic.density = c.real("RO", POSITIVE);
    elastic.E = c.real("E", POSITIVE);
    elastic.nu = c.real("PR", POISSON);
    c.harmless("DA DB K");
    material.card = elastic;
    draft.model.materials.push_back(material);
}

/// Any other material: of interest only if an element is of it, which is a fault then, or by its
/// density, where solids are taken as rigid.
void mat_other(Cards& cards, Draft& draft) {
    fabric::Material material;
    material.title = material_title(cards);
    Unread unread{cards.block().keyword, cards.block().place};
    {
        Card c = cards.next("MID RO - - - - - -");
        material.id = c.new_id("MID", draft.materials, draft.model.materials.size());
        unread.density = c.real("RO");
        c.harmless_all();
    }
    cards.abandon();
    draft.unread_materials[static_cast<Index>(draft.model.materials.size())] = unread;
    material.card = fabric::NullCard{1.0};
    draft.model.materials.push_back(material);
}

void mat_null(Cards& cards, Draft& draft) {
    fabric::Material material;
    material.title = material_title(cards);
    Card c = cards.next("MID RO PC MU TEROD CEROD YM PR");
    material.id = c.new_id("MID", draft.materials, draft.model.materials.size());
    material.card = fabric::NullCard{c.real("RO", POSITIVE)};
    c.harmless("PC MU TEROD CEROD YM PR");  // of fluids, and of LS-DYNA's contact stiffness
    draft.model.materials.push_back(material);
}

namespace {

/// CON1 names the axes; CON2 has a digit for x y z, rotation about x y z: 1 is held.
void hold_locally(Card& c, Draft& draft, fabric::RigidCard& rigid) {
    const Index system = c.row("CON1", draft.coordinates);
    int code = c.integer("CON2", within(0, 111111));
    unsigned held = 0;  // bit 0 is the first of six digits
    for (unsigned bit = 6; bit-- > 0; code /= 10) {
        if (code % 10 > 1) return c.fault("CON2", "six digits, each 0 or 1");
        held |= static_cast<unsigned>(code % 10) << bit;
    }
    rigid.fixed_moves = held & 7U;
    rigid.fixed_turns = held >> 3U;
    if (system >= 0 && draft.coordinate[static_cast<std::size_t>(system)].moves)
        c.warn("CON1", "the axes hold as they are at the start, FLAG of the system does not count");
    if (system >= 0)
        draft.local_constraints.emplace_back(static_cast<Index>(draft.model.materials.size()),
                                             system);
}

}  // namespace

void mat_rigid(Cards& cards, Draft& draft) {
    fabric::Material material;
    material.title = material_title(cards);
    fabric::RigidCard rigid;
    {
        Card c = cards.next("MID RO E PR N COUPLE M ALIAS");
        material.id = c.new_id("MID", draft.materials, draft.model.materials.size());
        rigid.density = c.real("RO", POSITIVE);
        rigid.E = c.real("E", POSITIVE);
        rigid.nu = c.real("PR", POISSON);
        c.harmless("ALIAS");
    }
    {
        Card c = cards.next("CMO CON1 CON2");
        const int axes = c.choice("CMO", {-1, 0, 1});
        if (axes < 0) {
            hold_locally(c, draft, rigid);
        } else {
            const int moves = c.integer("CON1", within(0, 7));
            const int turns = c.integer("CON2", within(0, 7));
            if (axes == 1)
                hold_along_axes(c.file(), HELD.at(static_cast<std::size_t>(moves)),
                                HELD.at(static_cast<std::size_t>(turns)), rigid);
        }
    }
    Card c = cards.next("A1 A2 A3 V1 V2 V3");
    c.harmless("A1 A2 A3 V1 V2 V3");  // axes of LS-DYNA's own output
    material.card = rigid;
    draft.model.materials.push_back(material);
}

namespace {

/// Whether shells that deform are of the material.
bool has_cloth(const Draft& draft, Index material) {
    const auto& shells = draft.model.shells;
    return std::any_of(shells.begin(), shells.end(), [&](const Shell& shell) {
        return shell.part >= 0 && !is_rigid(draft, shell.part) &&
               draft.model.parts[static_cast<std::size_t>(shell.part)].material == material;
    });
}

}  // namespace

/// *MAT_ADD_EROSION: of no account where it sets no limit, or where no shell could reach one.
void mat_add_erosion(Cards& cards, Draft& draft) {
    static const Layout first("MID EXCL MXPRES MNEPS EFFEPS VOLEPS NUMFIP=1 NCS=1"),
        rest("L1 L2 L3 L4 L5 L6 L7 L8");
    if (cards.has("TITLE")) cards.title();
    Card c = cards.next(first);
    const Index material = c.row("MID", draft.materials);
    const double unset = c.real("EXCL");
    bool sets_limits = false;
    const auto look = [&](Card& card, std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i) {
            const double limit = card.real(i);
            sets_limits |= limit != 0.0 && limit != unset;
        }
    };
    look(c, 2, 6);
    c.harmless_all();
    while (cards.rows()) {
        Card more = cards.next(rest);
        look(more, 0, 8);
    }
    if (material < 0) return;
    if (sets_limits && has_cloth(draft, material))
        c.fault("MID", "a material that is in no membrane: no element is taken out here");
    else if (c.good())
        cards.note(sets_limits ? "is not used: no membrane is of its material"
                               : "is not used: it sets no limit");
}

}  // namespace corpuscle::io::keywords
