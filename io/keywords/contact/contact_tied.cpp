// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "contact/geometry/distance.hpp"
#include "io/keywords/bodies/rigid_parts.hpp"
#include "io/keywords/contact/contact_surface.hpp"
#include "io/keywords/keywords.hpp"

/// *CONTACT_TIED_...: nodes of cloth that lie on rigid parts ride on them.
namespace corpuscle::io::keywords {
namespace {

/// How near is near enough: 0.6 of both thicknesses, or a twentieth of the facet's longest edge.
double reach(const Draft& draft, const Shell& facet, double thickness) {
    const auto& x = draft.model.x;
    double edge = 0.0;
    for (std::size_t k = 0; k < 4; ++k)
        edge = std::max(edge, (x[static_cast<std::size_t>(facet.nodes[k])] -
                               x[static_cast<std::size_t>(facet.nodes[(k + 1) % 4])])
                                  .norm());
    const Part& part = draft.model.parts[static_cast<std::size_t>(facet.part)];
    const double own = std::isnan(part.thickness) ? 0.0 : part.thickness;
    return std::max(0.6 * (own + thickness), 0.05 * edge);
}

/// All that it names is there; else it has a fault of its own.
bool is_whole(const Shell& shell) {
    return shell.part >= 0 &&
           std::all_of(shell.nodes.begin(), shell.nodes.end(), [](Index n) { return n >= 0; });
}

std::vector<const Shell*> shells_of(const Draft& draft, const ContactSide& side) {
    std::vector<const Shell*> shells;
    std::vector<std::uint8_t> is_parted(draft.model.parts.size(), 0);
    for (const Index s : side.some_shells) {
        const Shell& shell = draft.model.shells[static_cast<std::size_t>(s)];
        if (!is_whole(shell)) continue;
        shells.push_back(&shell);
        is_parted[static_cast<std::size_t>(shell.part)] = 1;
    }
    for (const Shell& shell : draft.model.shells)
        if (is_whole(shell) && is_parted[static_cast<std::size_t>(shell.part)] == 0 &&
            std::find(side.parts.begin(), side.parts.end(), shell.part) != side.parts.end())
            shells.push_back(&shell);
    return shells;
}

double distance_to(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 w = contact::foot_on_triangle(p, a, b, c);
    return (p - (w[0] * a + w[1] * b + w[2] * c)).norm();
}

/// The facet that the node lies on, or nullptr.
const Shell* facet_under(const Draft& draft, const std::vector<const Shell*>& facets, Index node,
                         double thickness) {
    const auto& x = draft.model.x;
    const Shell* best = nullptr;
    double nearest = INF;
    for (const Shell* facet : facets) {
        const auto corner = [&](std::size_t k) -> const Vec3& {
            return x[static_cast<std::size_t>(facet->nodes[k])];
        };
        const Vec3& p = x[static_cast<std::size_t>(node)];
        double d = distance_to(p, corner(0), corner(1), corner(2));
        if (!facet->is_triangle()) d = std::min(d, distance_to(p, corner(0), corner(2), corner(3)));
        if (d > reach(draft, *facet, thickness) || d >= nearest) continue;
        nearest = d;
        best = facet;
    }
    return best;
}

}  // namespace

void contact_tied(Cards& cards, Draft& draft) {
    if (cards.has("ID") || cards.has("TITLE")) cards.next("CID TITLE:70").harmless_all();
    if (cards.has("MPP")) {
        cards.next("IGNORE BCKET LCBCKT NS2TRK INITITR PARMAX - CPARM8").harmless_all();
        if (cards.starts_with('&')) cards.title();
    }
    ContactSide tied, base;
    {
        Card c = cards.next("SURFA SURFB SURFATYP SURFBTYP SABOXID SBBOXID SAPR SBPR");
        tied = contact_side(c, draft, SIDE_A, /*may_be_nodes=*/true);
        keep_in_box(c, draft, "SABOXID", tied);
        base = contact_side(c, draft, SIDE_B, /*may_be_nodes=*/false);
        keep_in_box(c, draft, "SBBOXID", base);
        c.harmless("SAPR SBPR");
        for (const Index part : base.parts)
            if (!is_rigid(draft, part))
                c.fault("SURFB",
                        fmt::format("rigid parts, part {} is none: cloth is tied to rigid parts "
                                    "alone",
                                    draft.model.parts[static_cast<std::size_t>(part)].id));
        if (!c.good()) return cards.abandon();
    }
    cards.abandon();  // friction, scales: of contacts that slide
    const std::vector<const Shell*> facets = shells_of(draft, base);
    std::set<Index> seen;
    std::size_t apart = 0, held = 0;
    for (const Shell* shell : shells_of(draft, tied)) {
        if (is_rigid(draft, shell->part)) continue;
        const double thickness = draft.model.parts[static_cast<std::size_t>(shell->part)].thickness;
        for (const Index node : shell->nodes) {
            if (!seen.insert(node).second) continue;
            const Shell* facet = facet_under(draft, facets, node, thickness);
            if (facet == nullptr) {
                ++apart;
                continue;
            }
            (void)rigid_owners(draft);
            Index& owner = draft.rigid_owner[static_cast<std::size_t>(node)];
            if (owner >= 0) continue;
            owner = lead_of(draft, facet->part);
            draft.model.rigid_extra_nodes.push_back({facet->part, node});
            ++held;
        }
    }
    if (held == 0) cards.fault("ties no node: none of SURFA lies on SURFB");
    cards.warn(
        fmt::format("ties {} nodes rigidly to the parts that they lie on; {} others lie "
                    "apart and are free",
                    held, apart));
}

}  // namespace corpuscle::io::keywords
