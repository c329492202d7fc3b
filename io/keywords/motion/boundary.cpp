// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <array>

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

}  // namespace

void boundary_spc_node(Cards& cards, Draft& draft) {
    static const Layout layout("NID CID DOFX DOFY DOFZ DOFRX DOFRY DOFRZ");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        const Index node = c.row("NID", draft.nodes);
        draft.model.supports.push_back({node, fixed_dofs(c)});
    }
}

void boundary_spc_set(Cards& cards, Draft& draft) {
    static const Layout layout("NSID CID DOFX DOFY DOFZ DOFRX DOFRY DOFRZ");
    while (cards.rows()) {
        if (cards.has("ID")) cards.title();
        Card c = cards.next(layout);
        const Index set = c.row("NSID", draft.node_sets);
        const DofMask fixed = fixed_dofs(c);
        if (set < 0) continue;
        for (const Index node : draft.node_set[static_cast<std::size_t>(set)])
            draft.model.supports.push_back({node, fixed});
    }
}

}  // namespace corpuscle::io::keywords
