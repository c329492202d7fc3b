// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/mesh/coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "io/keywords/keywords.hpp"

/// *DEFINE_COORDINATE_..., at rest: local x along one direction, local xy with another.
namespace corpuscle::io::keywords {

namespace {

/// z = x × v, y = z × x, all of length 1, as columns.
Mat3 axes_along(const Vec3& x, const Vec3& in_plane) {
    const Vec3 z = x.cross(in_plane);
    Mat3 axes;
    axes << x.normalized(), z.cross(x).normalized(), z.normalized();
    return axes;
}

bool spans(const Vec3& x, const Vec3& in_plane) {
    return x.cross(in_plane).norm() > 1e-6 * x.norm() * in_plane.norm();
}

void add(Card& c, Draft& draft, const char* field, const Vec3& x, const Vec3& in_plane) {
    LocalAxes system;
    if (c.good() && !spans(x, in_plane))
        c.fault(field, "two directions that span the local xy plane");
    else if (c.good())
        system.axes = axes_along(x, in_plane);
    draft.coordinate.push_back(system);
}

}  // namespace

void define_coordinate_system(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Vec3 origin, on_x;
        {
            Card c = cards.next("CID XO YO ZO XL YL ZL CIDL");  // CIDL: places in other axes
            c.new_id("CID", draft.coordinates, draft.coordinate.size());
            origin = c.point("XO", "YO", "ZO");
            on_x = c.point("XL", "YL", "ZL");
        }
        Card c = cards.next("XP YP ZP");
        add(c, draft, "XP", on_x - origin, c.point("XP", "YP", "ZP") - origin);
    }
}

void define_coordinate_vector(Cards& cards, Draft& draft) {
    while (cards.more()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("CID XX YX ZX XV YV ZV NID");  // NID: turns with a node
        c.new_id("CID", draft.coordinates, draft.coordinate.size());
        const Vec3 x = c.direction("XX", "YX", "ZX");
        add(c, draft, "XV", x, c.direction("XV", "YV", "ZV"));
    }
}

void define_coordinate_nodes(Cards& cards, Draft& draft) {
    while (cards.rows()) {
        if (cards.has("TITLE")) cards.title();
        Card c = cards.next("CID N1 N2 N3 FLAG DIR");
        c.new_id("CID", draft.coordinates, draft.coordinate.size());
        LocalAxes system;
        system.nodes = {c.row("N1", draft.nodes), c.row("N2", draft.nodes),
                        c.row("N3", draft.nodes)};
        system.moves = c.choice("FLAG", {0, 1}) == 1;
        if (c.given("DIR") && c.text("DIR") != "X" && c.text("DIR") != "x")
            c.fault("DIR", "X or blank: other axes are not acted on yet");
        const auto x = [&](int k) -> const Vec3& {
            return draft.model.x[static_cast<std::size_t>(system.nodes[k])];
        };
        if (c.good() && !spans(x(1) - x(0), x(2) - x(0)))
            c.fault("N3", "a node off the line through N1 and N2");
        draft.coordinate.push_back(system);
    }
}

Mat3 axes_at_start(const Draft& draft, Index system) {
    const LocalAxes& local = draft.coordinate[static_cast<std::size_t>(system)];
    if (std::any_of(local.nodes.begin(), local.nodes.end(), [](Index n) { return n < 0; }))
        return local.axes;
    const auto x = [&](int k) -> const Vec3& {
        return draft.model.x[static_cast<std::size_t>(local.nodes[k])];
    };
    return axes_along(x(1) - x(0), x(2) - x(0));
}

Vec3 local_axis(const FilePlace& file, int k, bool turns) {
    const bool is_against = file.mirrors() && (k == 2) != turns;
    return is_against ? Vec3(-Vec3::Unit(k)) : Vec3(Vec3::Unit(k));
}

void place_local_axes(Draft& draft) {
    for (const auto& [material, system] : draft.local_constraints)
        std::get<fabric::RigidCard>(draft.model.materials[static_cast<std::size_t>(material)].card)
            .axes = axes_at_start(draft, system);
}

}  // namespace corpuscle::io::keywords
