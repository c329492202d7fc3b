// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/held.hpp"
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

void mat_null(Cards& cards, Draft& draft) {
    fabric::Material material;
    material.title = material_title(cards);
    Card c = cards.next("MID RO PC MU TEROD CEROD YM PR");
    material.id = c.new_id("MID", draft.materials, draft.model.materials.size());
    material.card = fabric::NullCard{c.real("RO", POSITIVE)};
    c.harmless("PC MU TEROD CEROD YM PR");  // of fluids, and of LS-DYNA's contact stiffness
    draft.model.materials.push_back(material);
}

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
        const int global = c.choice("CMO", {0, 1}, {-1});
        const int moves = c.integer("CON1", within(0, 7));
        const int turns = c.integer("CON2", within(0, 7));
        if (global == 1) {
            rigid.fixed_moves = HELD.at(static_cast<std::size_t>(moves));
            rigid.fixed_turns = HELD.at(static_cast<std::size_t>(turns));
        }
    }
    Card c = cards.next("A1 A2 A3 V1 V2 V3");
    c.harmless("A1 A2 A3 V1 V2 V3");  // axes of LS-DYNA's own output
    material.card = rigid;
    draft.model.materials.push_back(material);
}

}  // namespace corpuscle::io::keywords
