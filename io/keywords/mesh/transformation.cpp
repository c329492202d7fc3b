// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

/// *DEFINE_TRANSFORMATION, and *NODE_TRANSFORM that places nodes by it.
namespace corpuscle::io::keywords {

namespace {

using Place3 = Eigen::Affine3d;

Place3 shift(Card& c) {
    return Place3(Eigen::Translation3d(c.vector("A1", "A2", "A3")));
}

/// Of the axes x, y, z; blank is 1.
Place3 scaling(Card& c) {
    Vec3 factor = c.vector("A1", "A2", "A3");
    for (int axis = 0; axis < 3; ++axis)
        if (factor[axis] == 0.0) factor[axis] = 1.0;
    if (c.good() && !(factor.minCoeff() > 0.0)) {
        c.fault("A1", "factors above 0");
        factor.setOnes();
    }
    return Place3(Eigen::Scaling(factor));
}

/// About the axis A1-A3 through the place A4-A6 by A7 degrees, right-handed.
Place3 turn(Card& c) {
    constexpr double DEGREE = M_PI / 180.0;
    const Vec3 axis = c.vector("A1", "A2", "A3"), through = c.vector("A4", "A5", "A6");
    const double angle = DEGREE * c.real("A7");
    if (!c.given("A7"))
        c.fault("A7",
                "an axis A1-A3, a place A4-A6 on it and an angle: turning by points is not "
                "acted on yet");
    else if (c.good() && axis.isZero(0.0))
        c.fault("A1", "an axis");
    if (!c.good()) return Place3::Identity();
    return Eigen::Translation3d(through) * Eigen::AngleAxisd(angle, axis.normalized()) *
           Eigen::Translation3d(-through);
}

Place3 line(Cards& cards) {
    Card c = cards.next("OPTION A1 A2 A3 A4 A5 A6 A7");
    const std::string option = upper(c.raw(0));
    if (option == "TRANSL") return shift(c);
    if (option == "SCALE") return scaling(c);
    if (option == "ROTATE") return turn(c);
    c.harmless_all();
    c.fault("OPTION", "TRANSL, SCALE or ROTATE");
    return Place3::Identity();
}

/// By node row: nodes whose place mass and centre of a rigid part have been found from.
std::vector<bool> weighed_nodes(const Draft& draft) {
    std::vector<bool> is_weighed(draft.model.x.size(), false);
    for (const Index node : draft.inertia_nodes) is_weighed[static_cast<std::size_t>(node)] = true;
    for (const Solid& solid : draft.solid)
        for (const Index node : solid.nodes) is_weighed[static_cast<std::size_t>(node)] = true;
    return is_weighed;
}

}  // namespace

void define_transformation(Cards& cards, Draft& draft) {
    if (cards.has("TITLE")) cards.title();
    {
        Card c = cards.next("TRANID");
        c.new_id("TRANID", draft.transformations, draft.transformation.size());
    }
    Place3 whole = Place3::Identity();
    while (cards.rows()) whole = line(cards) * whole;
    draft.transformation.push_back(whole);
}

void node_transform(Cards& cards, Draft& draft) {
    static const Layout layout("TRSID NSID IMMED");
    const std::vector<bool> is_weighed = weighed_nodes(draft);
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Index by = c.row("TRSID", draft.transformations);
        const Index set = c.row("NSID", draft.node_sets);
        c.harmless("IMMED");  // nodes are placed before anything looks at where they are
        if (by < 0 || set < 0) continue;
        std::vector<Index> nodes = draft.node_set[static_cast<std::size_t>(set)];
        std::sort(nodes.begin(), nodes.end());
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        const auto weighed = std::find_if(nodes.begin(), nodes.end(), [&](Index node) {
            return is_weighed[static_cast<std::size_t>(node)];
        });
        if (weighed != nodes.end()) {
            c.fault("NSID", fmt::format("no nodes of solids and no NODEID of *PART_INERTIA, whose "
                                        "mass would stay behind: node {} is one",
                                        draft.model.node_id[static_cast<std::size_t>(*weighed)]));
            continue;
        }
        for (const Index node : nodes) {
            Vec3& x = draft.model.x[static_cast<std::size_t>(node)];
            x = draft.transformation[static_cast<std::size_t>(by)] * x;
        }
    }
}

}  // namespace corpuscle::io::keywords
