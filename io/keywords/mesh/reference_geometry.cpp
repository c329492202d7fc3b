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

/// X_0 + S (X - X_0), along the axes of the file that says S.
Vec3 scaled(const Vec3& at, const Vec3& origin, const Scaling& by, const FilePlace& file) {
    const Vec3 from = file.written(origin);
    return file.point(from + by.factor.cwiseProduct(file.written(at) - from));
}

/// X_0 is the reference place of NIDO.
void scale(ReferenceGeometry& reference, const Scaling& by, const FilePlace& file,
           const Points& x) {
    if (reference.nodes.empty() || by.factor == Vec3::Ones()) return;
    Vec3 origin = reference.nodes.front().second;
    if (by.about >= 0) {
        origin = x[static_cast<std::size_t>(by.about)];
        for (const auto& [row, at] : reference.nodes)
            if (row == by.about) origin = at;
    }
    for (auto& [row, at] : reference.nodes) at = scaled(at, origin, by, file);
}

}  // namespace

void airbag_reference_geometry(Cards& cards, Draft& draft) {
    static const Layout place("NID:8 X:16 Y:16 Z:16");
    ReferenceGeometry reference;
    Scaling scaling;
    if (cards.has("ID")) scaling = id_card(cards, draft);
    if (cards.has("BIRTH")) {
        Card c = cards.next("BIRTH");
        reference.birth = c.real("BIRTH", NON_NEGATIVE);
    }
    Registry seen("*AIRBAG_REFERENCE_GEOMETRY node");
    while (cards.rows()) {
        Card c = cards.next(place);
        const Index row = c.row(std::size_t{0}, draft.nodes);
        const Vec3 at = c.point("X", "Y", "Z");
        if (row >= 0 && !seen.add(row, row, c.place()))
            c.fault("NID", fmt::format("each node once, but {} has it too",
                                       cards.faults().where(seen.find(row)->place)));
        else if (row >= 0)
            reference.nodes.emplace_back(row, at);
    }
    if (reference.nodes.empty() && cards.good()) cards.fault("has no nodes, expected some");
    scale(reference, scaling, cards.file(), draft.model.x);
    draft.model.references.push_back(std::move(reference));
}

namespace {

/// One row: a shell and the nodes whose places are its stress-free corners.
ShellReference shell_row(Cards& cards, const Draft& draft, Registry& seen) {
    static const Layout row("EID:8 PID:8 N1:8 N2:8 N3:8 N4:8");
    Card c = cards.next(row);
    ShellReference reference;
    reference.shell = c.row(std::size_t{0}, draft.shells);
    const Index part = c.row(std::size_t{1}, draft.parts);
    for (std::size_t i = 0; i < 4; ++i) {
        if (i == 3 && !c.given(5)) {
            reference.corners[3] = reference.corners[2];
            continue;
        }
        const Index node = c.row(i + 2, draft.nodes);
        if (node >= 0) reference.corners[i] = draft.model.x[static_cast<std::size_t>(node)];
    }
    if (c.file().mirrors()) {  // as the shell's own
        std::swap(reference.corners[0], reference.corners[1]);
        std::swap(reference.corners[2], reference.corners[3]);
    }
    if (reference.shell < 0 || part < 0) return reference;
    if (draft.model.shells[static_cast<std::size_t>(reference.shell)].part != part)
        c.fault("PID", "the part of the shell");
    if (!seen.add(reference.shell, reference.shell, c.place()))
        c.fault("EID", fmt::format("each shell once, but {} has it too",
                                   cards.faults().where(seen.find(reference.shell)->place)));
    return reference;
}

}  // namespace

void airbag_shell_reference_geometry(Cards& cards, Draft& draft) {
    Scaling scaling;
    if (cards.has("ID")) scaling = id_card(cards, draft);
    Registry seen("*AIRBAG_SHELL_REFERENCE_GEOMETRY shell");
    std::vector<ShellReference> references;
    while (cards.rows()) references.push_back(shell_row(cards, draft, seen));
    if (references.empty() && cards.good()) cards.fault("has no shells, expected some");
    if (references.empty()) return;
    const Vec3 origin = scaling.about >= 0 ? draft.model.x[static_cast<std::size_t>(scaling.about)]
                                           : references.front().corners[0];
    for (ShellReference& reference : references) {
        for (Vec3& at : reference.corners) at = scaled(at, origin, scaling, cards.file());
        draft.model.shell_references.push_back(reference);
    }
}

}  // namespace corpuscle::io::keywords
