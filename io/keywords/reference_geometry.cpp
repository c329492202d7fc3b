// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

namespace {

struct Scaling {
    Vec3 factor = Vec3::Ones();
    Index about = -1;  ///< NIDO: node row, or the first node of the table
};

Scaling id_card(Cards& cards, const Draft& draft) {
    Card c = cards.next("ID SX=1 SY=1 SZ=1 NIDO IOUT");
    c.harmless("ID IOUT");
    Scaling scaling;
    scaling.factor = {c.real("SX", POSITIVE), c.real("SY", POSITIVE), c.real("SZ", POSITIVE)};
    scaling.about = c.row_or_none("NIDO", draft.nodes);
    return scaling;
}

/// X_0 + S (X - X_0), X_0 the reference place of NIDO.
void scale(ReferenceGeometry& reference, const Scaling& by, const Points& x) {
    if (reference.nodes.empty() || by.factor == Vec3::Ones()) return;
    Vec3 origin = reference.nodes.front().second;
    if (by.about >= 0) {
        origin = x[static_cast<std::size_t>(by.about)];
        for (const auto& [row, at] : reference.nodes)
            if (row == by.about) origin = at;
    }
    for (auto& [row, at] : reference.nodes) at = origin + by.factor.cwiseProduct(at - origin);
}

}  // namespace

void airbag_reference_geometry(Cards& cards, Draft& draft) {
    static const Layout place("NID:8 X:16 Y:16 Z:16");
    ReferenceGeometry reference;
    Scaling scaling;
    if (cards.has("ID")) scaling = id_card(cards, draft);
    if (cards.has("BIRTH")) reference.birth = cards.next("BIRTH").real("BIRTH", NON_NEGATIVE);
    Registry seen("*AIRBAG_REFERENCE_GEOMETRY node");
    while (cards.rows()) {
        Card c = cards.next(place);
        const Index row = c.row(std::size_t{0}, draft.nodes);
        const Vec3 at(c.real(std::size_t{1}), c.real(std::size_t{2}), c.real(std::size_t{3}));
        if (row >= 0 && !seen.add(row, row, c.place()))
            c.fault("NID", fmt::format("each node once, but {} has it too",
                                       cards.faults().where(seen.find(row)->place)));
        else if (row >= 0)
            reference.nodes.emplace_back(row, at);
    }
    if (reference.nodes.empty() && cards.good()) cards.fault("has no nodes, expected some");
    scale(reference, scaling, draft.model.x);
    draft.model.references.push_back(std::move(reference));
}

}  // namespace corpuscle::io::keywords
