// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/model/transformation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "io/keywords/keywords.hpp"
#include "io/text/text.hpp"

/// *DEFINE_TRANSFORMATION, and *NODE_TRANSFORM that places nodes by it.
namespace corpuscle::io::keywords {

namespace {

using Step = TransformationStep;
using Kind = Step::Kind;
using Eigen::Affine3d;

constexpr double DEGREE = M_PI / 180.0;
constexpr double LEAST_FACTOR = 1e-9, MOST_FACTOR = 1e9;  ///< of lengths
constexpr const char* OPTIONS =
    "TRANSL, TRANSL2ND, SCALE, ROTATE, ROTATE3NA, MIRROR, POINT, POS6P or POS6N";
constexpr const char* FIELDS[] = {"A1", "A2", "A3", "A4", "A5", "A6"};

/// POINT rows of one transformation, by their ids.
using PointRows = std::map<int, Vec3>;

Affine3d shift(Card& c) {
    return Affine3d(Eigen::Translation3d(c.vector("A1", "A2", "A3")));
}

/// Of the axes x, y, z; blank is 1, below 0 mirrors.
Affine3d scaling(Card& c) {
    Vec3 factor = c.vector("A1", "A2", "A3");
    for (int axis = 0; axis < 3; ++axis) {
        if (factor[axis] == 0.0) factor[axis] = 1.0;
        const double size = std::abs(factor[axis]);
        if (c.good() && !(size >= LEAST_FACTOR && size <= MOST_FACTOR)) {
            c.fault(FIELDS[axis], fmt::format("a factor of {:g} to {:g}, or minus one",
                                              LEAST_FACTOR, MOST_FACTOR));
            factor.setOnes();
        }
    }
    return Affine3d(Eigen::Scaling(factor));
}

/// About the axis A1-A3 through the place A4-A6 by A7 degrees, right-handed.
Affine3d turn(Card& c) {
    const Vec3 axis = c.vector("A1", "A2", "A3"), through = c.vector("A4", "A5", "A6");
    const double angle = DEGREE * c.real("A7");
    if (!c.given("A7"))
        c.fault("A7",
                "an axis A1-A3, a place A4-A6 on it and an angle; or two POINTs and an angle "
                "in A3");
    else if (c.good() && axis.isZero(0.0))
        c.fault("A1", "an axis");
    if (!c.good()) return Affine3d::Identity();
    return Eigen::Translation3d(through) * Eigen::AngleAxisd(angle, axis.normalized()) *
           Eigen::Translation3d(-through);
}

/// In the plane through A1-A3, square to the way from there to A4-A6.
Affine3d mirror(Card& c) {
    const Vec3 at = c.vector("A1", "A2", "A3"), normal = c.vector("A4", "A5", "A6") - at;
    c.choice("A7", {0, 1});
    c.harmless("A7");  // axes of coordinate systems hold and turn things alike in both hands
    if (c.good() && normal.isZero(0.0)) c.fault("A4", "a place away from A1-A3");
    if (!c.good()) return Affine3d::Identity();
    const Vec3 n = normal.normalized();
    const Affine3d reflection(Mat3(Mat3::Identity() - 2.0 * n * n.transpose()));
    return Eigen::Translation3d(at) * reflection * Eigen::Translation3d(-at);
}

/// With A4 to A7 zero, A1 and A2 are POINTs and A3 is the angle.
bool is_by_points(Card& c, const PointRows& points) {
    for (const char* field : {"A4", "A5", "A6", "A7"})
        if (c.given(field) && c.real(field) != 0.0) return false;
    const double first = c.real("A1"), second = c.real("A2");
    const auto is_id = [](double value) { return value >= 1.0 && value == std::floor(value); };
    return is_id(first) && is_id(second) && (!points.empty() || !c.given("A7"));
}

Vec3 point_named(Card& c, const char* field, const PointRows& points) {
    const auto found = points.find(c.integer(field));
    if (found != points.end()) return found->second;
    c.fault(field, "the id of a POINT row above, in this transformation");
    return Vec3::Zero();
}

void rotate(Card& c, const PointRows& points, Step& step) {
    if (!is_by_points(c, points)) {
        step.map = turn(c);
        return;
    }
    step.kind = Kind::ROTATE_BY_POINTS;
    step.points[0] = point_named(c, "A1", points);
    step.points[1] = point_named(c, "A2", points);
    step.amount = DEGREE * c.real("A3");
    if (c.good() && step.points[0] == step.points[1]) c.fault("A2", "a POINT away from the first");
}

void add_point(Card& c, PointRows& points) {
    const int id = c.integer("A1", {1.0});
    const Vec3 at = c.vector("A2", "A3", "A4");
    if (c.good() && !points.emplace(id, at).second)
        c.fault("A1", "an id that no other POINT of this transformation has");
}

void six(Card& c, const PointRows& points, Step& step) {
    step.kind = Kind::SIX_POINTS;
    for (std::size_t i = 0; i < 6; ++i) step.points[i] = point_named(c, FIELDS[i], points);
    for (const std::size_t first : {0U, 3U})
        if (c.good() &&
            !spans_plane(step.points[first], step.points[first + 1], step.points[first + 2]))
            c.fault(FIELDS[first], "three POINTs that span a plane");
}

void by_nodes(Card& c, const Draft& draft, Kind kind, std::size_t count, Step& step) {
    step.kind = kind;
    for (std::size_t i = 0; i < count; ++i) step.nodes[i] = c.row(FIELDS[i], draft.nodes);
}

void read_row(Cards& cards, const Draft& draft, PointRows& points, Transformation& all) {
    Card c = cards.next("OPTION A1 A2 A3 A4 A5 A6 A7");
    const std::string option = upper(c.raw(0));
    Step step;
    step.place = c.place();
    if (option == "POINT") return add_point(c, points);
    if (option == "TRANSL") {
        step.map = shift(c);
    } else if (option == "SCALE") {
        step.map = scaling(c);
    } else if (option == "MIRROR") {
        step.map = mirror(c);
    } else if (option == "ROTATE") {
        rotate(c, points, step);
    } else if (option == "POS6P") {
        six(c, points, step);
        if (!all.steps.empty())
            c.warn("OPTION", "the start points are moved by the rows above, the targets are not");
    } else if (option == "POS6N") {
        by_nodes(c, draft, Kind::SIX_NODES, 6, step);
    } else if (option == "TRANSL2ND") {
        by_nodes(c, draft, Kind::TRANSLATE_BY_NODES, 2, step);
        step.amount = c.real("A3");
    } else if (option == "ROTATE3NA") {
        by_nodes(c, draft, Kind::ROTATE_BY_NODES, 3, step);
        step.amount = DEGREE * c.real("A4");
    } else {
        c.harmless_all();
        c.fault("OPTION", OPTIONS);
    }
    if (c.good()) all.steps.push_back(step);
}

/// By node row: nodes whose place mass and centre of a rigid part have been found from.
std::vector<bool> weighed_nodes(const Draft& draft) {
    std::vector<bool> is_weighed(draft.model.x.size(), false);
    for (const Index node : draft.inertia_nodes) is_weighed[static_cast<std::size_t>(node)] = true;
    for (const Solid& solid : draft.solid)
        for (const Index node : solid.nodes) is_weighed[static_cast<std::size_t>(node)] = true;
    return is_weighed;
}

/// Acts on nodes that are in the scene already, in the coordinates of the card's file. Rows that name
/// some of `moved` see these move on.
void move(const Transformation& transformation, const FilePlace& file,
          const std::vector<Index>& moved, Points& x, Faults& faults) {
    const auto place_of = [&](Index node, const Affine3d& so_far) -> Vec3 {
        const Vec3 at = file.written(x[static_cast<std::size_t>(node)]);
        return std::binary_search(moved.begin(), moved.end(), node) ? Vec3(so_far * at) : at;
    };
    const Affine3d map = transformation.map(place_of, faults);
    for (const Index node : moved) {
        Vec3& at = x[static_cast<std::size_t>(node)];
        at = file.point(map * file.written(at));
    }
}

}  // namespace

void define_transformation(Cards& cards, Draft& draft) {
    if (cards.has("TITLE")) cards.title();
    Transformation transformation;
    {
        Card c = cards.next("TRANID");
        transformation.id = c.new_id("TRANID", draft.transformations, draft.transformation.size());
    }
    PointRows points;
    while (cards.rows()) read_row(cards, draft, points, transformation);
    draft.transformation.push_back(std::move(transformation));
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
        move(draft.transformation[static_cast<std::size_t>(by)], c.file(), nodes, draft.model.x,
             cards.faults());
    }
}

}  // namespace corpuscle::io::keywords
