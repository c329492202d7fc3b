// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <utility>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

constexpr std::array DOFS = {"DOFX", "DOFY", "DOFZ", "DOFRX", "DOFRY", "DOFRZ"};

DofMask fixed_dofs(Card& c) {
    DofMask fixed = 0;
    for (std::size_t i = 0; i < DOFS.size(); ++i)
        if (c.choice(DOFS[i], {0, 1}) == 1) fixed |= 1U << i;
    const auto held = c.file().held(fixed);
    if (!held)
        c.fault("DOFX", "what is held along axes of the deck, into which its file is turned");
    return held.value_or(0);
}

/// CID counts for nothing where all directions are held.
void expect_deck_axes(Card& c, DofMask fixed) {
    const DofMask moves = fixed & 7U, turns = fixed >> 3U;
    if (moves == 7U && (turns == 0U || turns == 7U)) return c.harmless("CID");
    if (c.given("CID") && c.integer("CID") != 0)
        c.fault("CID", "0 or blank, or all directions held: local axes are not acted on yet");
}

/// _BIRTH_DEATH: a support holds from the start to the end.
void window(Cards& cards, const Draft& draft) {
    if (!cards.has("BIRTH") && !cards.has("DEATH")) return;
    Card c = cards.next("BIRTH DEATH=1e20");
    if (c.real("BIRTH") > 0.0) c.fault("BIRTH", "0: supports hold from the start on");
    if (c.real("DEATH") < std::max(draft.until, draft.model.end_time))
        c.fault("DEATH", "a time that is not before the end: supports hold to the end");
}

/// One of a node or of a set: what it names, and how it is held.
std::pair<Index, DofMask> support(Cards& cards, const Draft& draft, const char* name,
                                  const Registry& things) {
    static const Layout node("NID CID DOFX DOFY DOFZ DOFRX DOFRY DOFRZ"),
        set("NSID CID DOFX DOFY DOFZ DOFRX DOFRY DOFRZ");
    if (cards.has("ID")) cards.title();
    std::pair<Index, DofMask> held;
    {
        Card c = cards.next(&things == &draft.nodes ? node : set);
        held.first = c.row(name, things);
        held.second = fixed_dofs(c);
        expect_deck_axes(c, held.second);
    }
    window(cards, draft);
    return held;
}

}  // namespace

void boundary_spc_node(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        const auto [node, fixed] = support(cards, draft, "NID", draft.nodes);
        draft.model.supports.push_back({node, fixed});
    }
}

void boundary_spc_set(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        const auto [set, fixed] = support(cards, draft, "NSID", draft.node_sets);
        if (set < 0) continue;
        for (const Index node : draft.node_set[static_cast<std::size_t>(set)])
            draft.model.supports.push_back({node, fixed});
    }
}

}  // namespace corpuscle::io::keywords
