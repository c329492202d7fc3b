// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

#include "io/keywords/bodies/held.hpp"
#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

void node(Cards& cards, Draft& draft) {
    static const Layout layout("NID:8 X:16 Y:16 Z:16 TC:8 RC:8");
    Model& model = draft.model;
    const std::size_t n = model.x.size() + cards.block().lines.size();
    draft.nodes.reserve(n);
    model.node_id.reserve(n);
    model.x.reserve(n);
    draft.node_files.emplace_back(static_cast<Index>(model.x.size()), cards.block().inclusion);
    while (cards.rows()) {
        Card c = cards.next(layout);
        const auto row = static_cast<Index>(model.x.size());
        const int id = c.new_id(std::size_t{0}, draft.nodes, model.x.size());
        const Vec3 at(c.real(std::size_t{1}), c.real(std::size_t{2}), c.real(std::size_t{3}));
        const int moves = c.integer(std::size_t{4}, within(0, 7));
        const int turns = c.integer(std::size_t{5}, within(0, 7));
        const unsigned fixed = HELD.at(static_cast<std::size_t>(moves)) |
                               HELD.at(static_cast<std::size_t>(turns)) << 3U;
        if (fixed != 0) model.supports.push_back({row, fixed});
        model.node_id.push_back(id);
        model.x.push_back(at);
    }
}

namespace {

/// A triangle is written with its third node twice, or with none in fourth place.
bool is_sound(const std::array<Index, 4>& n) {
    return n[0] != n[1] && n[1] != n[2] && n[2] != n[0] && n[3] != n[0] && n[3] != n[1];
}

/// _THICKNESS, _BETA: a second line, which may say no more than the part's section does.
void own_thickness(Cards& cards, const Draft& draft, Index part) {
    static const Layout layout("THIC1:16 THIC2:16 THIC3:16 THIC4:16 BETA:16");
    constexpr double SAME = 1e-6;
    Card c = cards.next(layout);
    if (c.real("BETA") != 0.0)
        c.fault("BETA",
                "0: an angle of a shell's own is not acted on yet (BETA of *MAT_FABRIC is)");
    const Index section = part < 0 ? -1 : draft.part_section[static_cast<std::size_t>(part)];
    const double thickness =
        section < 0 ? 0.0 : draft.section[static_cast<std::size_t>(section)].thickness;
    for (const char* corner : {"THIC1", "THIC2", "THIC3", "THIC4"}) {
        const double t = c.real(corner, NON_NEGATIVE);
        if (t != 0.0 && thickness > 0.0 && std::abs(t - thickness) > SAME * thickness)
            c.fault(corner, fmt::format("0 or {:g}, the thickness of its section: a part is as "
                                        "thick everywhere here",
                                        thickness));
    }
}

}  // namespace

void element_shell(Cards& cards, Draft& draft) {
    static const Layout layout("EID:8 PID:8 N1:8 N2:8 N3:8 N4:8 N5:8 N6:8 N7:8 N8:8");
    std::vector<Shell>& shells = draft.model.shells;
    const std::size_t n = shells.size() + cards.block().lines.size();
    draft.shells.reserve(n);
    shells.reserve(n);
    while (cards.rows()) {
        Card c = cards.next(layout);
        Shell shell;
        shell.id = c.new_id(std::size_t{0}, draft.shells, shells.size());
        shell.part = c.row(std::size_t{1}, draft.parts);
        if (shell.part >= 0 && draft.part_has_solids[static_cast<std::size_t>(shell.part)] != 0)
            c.fault(std::size_t{1}, "a part with *SECTION_SHELL");
        for (std::size_t k = 0; k < 3; ++k) shell.nodes[k] = c.row(k + 2, draft.nodes);
        const bool is_triangle = c.raw(4) == c.raw(5);
        const Index fourth = is_triangle ? -1 : c.row_or_none("N4", draft.nodes);
        shell.nodes[3] = fourth < 0 ? shell.nodes[2] : fourth;
        if (c.good() && !is_sound(shell.nodes))
            c.fault("N1", "no node twice, but for N4 = N3 of a triangle");
        shell.nodes = c.file().facet(shell.nodes);
        if (c.file().mirrors() && !shell.is_triangle())
            draft.model.mirrored_quads.push_back(static_cast<Index>(shells.size()));
        shells.push_back(shell);
        if (cards.has("THICKNESS") || cards.has("BETA")) own_thickness(cards, draft, shell.part);
    }
}

void element_mass(Cards& cards, Draft& draft) {
    static const Layout layout("EID:8 NID:8 MASS:16 PID:8");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index node = c.row("NID", draft.nodes);
        const double mass = c.real("MASS", NON_NEGATIVE);
        c.harmless("EID PID");
        if (draft.model.node_masses.empty()) draft.node_masses_at = c.place();
        if (node >= 0) draft.model.node_masses.push_back({node, mass});
    }
}

/// EID NID CSID, then the tensor and the mass, which count as *ELEMENT_MASS.
void element_inertia(Cards& cards, Draft& draft) {
    static const Layout first("EID:8 NID:8 CSID:8"), second("IXX IXY IXZ IYY IYZ IZZ MASS");
    constexpr double ROUNDING = 1e-9;
    while (cards.rows()) {
        Index node = -1;
        Place place;
        {
            Card c = cards.next(first);
            node = c.row("NID", draft.nodes);
            c.harmless("EID");
            if (c.integer("CSID") != 0) c.fault("CSID", "0: a tensor along the axes of the deck");
            place = c.place();
        }
        Card c = cards.next(second);
        const double mass = c.real("MASS", NON_NEGATIVE);
        const double xy = c.real("IXY"), xz = c.real("IXZ"), yz = c.real("IYZ");
        Mat3 inertia;
        inertia << c.real("IXX"), xy, xz, xy, c.real("IYY"), yz, xz, yz, c.real("IZZ");
        const Vec3 moments = Eigen::SelfAdjointEigenSolver<Mat3>(inertia).eigenvalues();
        if (c.good() && moments[0] < -ROUNDING * moments.cwiseAbs().maxCoeff())
            c.fault("IXX", "a tensor whose three principal moments are not below 0");
        if (!c.good() || node < 0) continue;
        if (draft.model.node_masses.empty()) draft.node_masses_at = place;
        draft.model.node_masses.push_back({node, mass});
        if (inertia.isZero(0.0)) continue;
        const Mat3& turn = c.file().turn();
        draft.model.node_inertias.push_back({node, turn * inertia * turn.transpose()});
        draft.node_inertias_at.push_back(place);
    }
}

/// The mass is that of each node.
void element_mass_node_set(Cards& cards, Draft& draft) {
    static const Layout layout("EID:8 NSID:8 MASS:16 PID:8");
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index set = c.row("NSID", draft.node_sets);
        const double mass = c.real("MASS", NON_NEGATIVE);
        c.harmless("EID PID");
        if (draft.model.node_masses.empty()) draft.node_masses_at = c.place();
        if (set < 0) continue;
        for (const Index node : draft.node_set[static_cast<std::size_t>(set)])
            draft.model.node_masses.push_back({node, mass});
    }
}

}  // namespace corpuscle::io::keywords
