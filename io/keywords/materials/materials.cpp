// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
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

}  // namespace corpuscle::io::keywords
