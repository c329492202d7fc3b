// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/fold.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "solver/base/error.hpp"
#include "tools/fold/inspect/inspect.hpp"
#include "tools/fold/mesh/imprint.hpp"
#include "tools/fold/mesh/improve.hpp"

namespace corpuscle::fold {
namespace {

/// How a mesh is made for the folds. Where the bends of oblique folds meet, facets are twisted, and
/// meshes of layers that do not match may come too close: then another mesh helps, or a finer one.
struct Way {
    double snap;    ///< share of an edge that a node moves to a fold's border at most
    int parts;      ///< of a band
    bool is_alike;  ///< each layer of the bag has the holes of all others in its mesh
};
constexpr std::array WAYS{Way{0.35, 1, false}, Way{0.35, 1, true}, Way{0.25, 1, true},
                          Way{0.35, 2, true},  Way{0.25, 2, true}, Way{0.3, 3, true}};
/// Nodes on other lines that are nearer to a border than this share of an edge count as on it:
/// slivers would be worse.
constexpr double GIVES_WAY = 0.08;
/// Of an element: reach of cells that lose an edge once all is folded; how far lines move for it;
/// what is left as it is round a crossing. And how often that is tried.
constexpr double TOO_SMALL = 0.15, SLACK = 0.12, ROUND_CROSSING = 1.5;
constexpr int TRIES = 6;
constexpr int FIRST_NAME = 2000000;

/// All moves, with the bands that the draft needs.
std::vector<Move> plan_folds(const Recipe& r, Points x, double size) {
    std::vector<Move> all;
    for (const Step& step : r.steps)
        for (Move move : step.moves) {
            std::visit(
                [&](auto& fold) {
                    choose_bands(fold, x, r.pattern.gap, size);
                    apply(fold, r.pattern.gap, x);
                },
                move);
            all.push_back(move);
        }
    return all;
}

/// Quads count as two triangles, cut from their first corner to their third. Those that come to lie
/// on each other shall be cut alike, so a quad that is turned over gets the other diagonal.
template <class Fold>
void turn_diagonals(const Fold& fold, Sheet& s) {
    for (Cell& c : s.cells)
        if (corner_count(c) == 4 &&
            is_turned(fold, (s.x[c[0]] + s.x[c[1]] + s.x[c[2]] + s.x[c[3]]) / 4.0))
            std::rotate(c.begin(), c.begin() + 1, c.end());
}

enum class Panel { BACK, FRONT };

bool is_of(Panel panel, const Bag& bag, std::size_t cell) {
    const BagPart& part = bag.parts[static_cast<std::size_t>(bag.sheet.part[cell])];
    return part.is_front == (panel == Panel::FRONT) && part.title != "tethers";
}

/// By node: does the front share it with the back? Lines across the seam have added to its nodes.
std::vector<char> sewn_nodes(const Bag& bag) {
    std::vector<char> in_front(bag.sheet.x.size(), 0), in_back(in_front), in_both(in_front);
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e)
        for (const Index n : bag.sheet.cells[e]) {
            if (is_of(Panel::FRONT, bag, e)) in_front[n] = 1;
            if (is_of(Panel::BACK, bag, e)) in_back[n] = 1;
        }
    for (std::size_t n = 0; n < in_both.size(); ++n) in_both[n] = in_front[n] & in_back[n];
    return in_both;
}

/// The panel's cells at an edge.
std::vector<std::size_t> cells_at(Panel panel, const Bag& bag, Index a, Index b) {
    std::vector<std::size_t> rows;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        const Cell& c = bag.sheet.cells[e];
        if (!is_of(panel, bag, e)) continue;
        for (int k = 0, count = corner_count(c); k < count; ++k)
            if (std::pair(c[k], c[(k + 1) % count]) == std::pair(a, b) ||
                std::pair(c[k], c[(k + 1) % count]) == std::pair(b, a))
                rows.push_back(e);
    }
    return rows;
}

/// A node of the panel's own in the middle of an edge, a little towards the panel's side.
Index middle_node(Panel panel, Index a, Index b, Bag& bag) {
    // Of what lies between the panels beside the edge, but not so far that the edge is stretched
    constexpr double ASIDE = 0.25, OF_EDGE = 0.1;
    const auto middle_of_cells = [&](Panel of) {
        Vec3 sum = Vec3::Zero();
        const auto rows = cells_at(of, bag, a, b);
        for (const std::size_t e : rows)
            for (const Index n : bag.sheet.cells[e])
                sum += bag.sheet.x[n] / (4.0 * static_cast<double>(rows.size()));
        return sum;
    };
    const Panel other = panel == Panel::BACK ? Panel::FRONT : Panel::BACK;
    const Vec3 apart = middle_of_cells(panel) - middle_of_cells(other);
    const double edge = (bag.sheet.x[b] - bag.sheet.x[a]).norm();
    const Vec3 aside = std::min(ASIDE, OF_EDGE * edge / apart.norm()) * apart;
    bag.sheet.X.emplace_back(0.5 * (bag.sheet.X[a] + bag.sheet.X[b]));
    bag.sheet.x.emplace_back(0.5 * (bag.sheet.x[a] + bag.sheet.x[b]) + aside);
    bag.sheet.on.emplace_back();
    return static_cast<Index>(bag.sheet.X.size()) - 1;
}

/// The cells at an edge of the panel are cut at a node in its middle.
void split_edge(Panel panel, Index a, Index b, Bag& bag) {
    const auto rows = cells_at(panel, bag, a, b);
    const Index m = middle_node(panel, a, b, bag);
    for (const std::size_t e : rows) {
        Cell c = bag.sheet.cells[e];
        const int count = corner_count(c);
        const auto end = c.begin() + count;
        int k = 0;  // the edge begins there
        while (std::minmax(c[k], c[(k + 1) % count]) != std::minmax(a, b)) ++k;
        std::rotate(c.begin(), c.begin() + k, end);
        const Index p = c[0], q = c[1], r = c[2], s = c[3];
        bag.sheet.cells[e] = {m, q, r, r};
        bag.sheet.cells.push_back(count == 3 ? Cell{m, r, p, p} : Cell{m, r, s, p});
        bag.sheet.part.push_back(bag.sheet.part[e]);
    }
}

/// A rectangle's corner is a quad with three nodes on the seam, or, where a line crosses it, a
/// triangle. Cut alike in both panels they would have that cut in common, an edge where four facets
/// meet. In one panel the quad is cut from the corner inward; the triangle's edge, which is the
/// border of a fold, gets a node of its own.
/// @returns  was there any?
bool cut_corners_inward(Panel panel, Bag& bag) {
    const std::vector<char> is_sewn = sewn_nodes(bag);
    bool is_cut = false;
    std::map<std::pair<Index, Index>, int> cells;  // of both panels, by edge between sewn nodes
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        Cell& c = bag.sheet.cells[e];
        const int count = corner_count(c);
        if (is_of(panel, bag, e) && count == 4 && is_sewn[c[0]] && is_sewn[c[2]]) {
            std::rotate(c.begin(), c.begin() + 1, c.end());
            is_cut = true;
        }
        if (!is_of(Panel::BACK, bag, e) && !is_of(Panel::FRONT, bag, e)) continue;
        for (int k = 0; k < count; ++k)
            if (is_sewn[c[k]] && is_sewn[c[(k + 1) % count]])
                ++cells[std::minmax(c[k], c[(k + 1) % count])];
    }
    for (const auto& [edge, count] : cells) {
        if (count <= 2) continue;
        split_edge(panel, edge.first, edge.second, bag);
        is_cut = true;
    }
    return is_cut;
}

Bag fold_once(const Recipe& recipe, const std::vector<Move>& folds, Way way) {
    const double gap = recipe.pattern.gap;
    Bag bag = make_bag(recipe, plan_lines(folds, gap, way.parts), way.is_alike);
    int name = FIRST_NAME;
    const auto do_move = [&](const auto& fold) {
        for (const double border : borders(fold, way.parts))
            imprint(bag.sheet,
                    {name++, distance(fold, border, bag.sheet.x), way.snap, GIVES_WAY, {}});
        turn_diagonals(fold, bag.sheet);
        apply(fold, gap, bag.sheet.x);
    };
    for (const Move& move : folds) std::visit(do_move, move);
    return bag;
}

/// The cover's inner nodes go down, folded and flat alike: a dish with a straight wall of one
/// element.
void press_dish(double depth, Bag& bag) {
    std::vector<char> is_cover(bag.sheet.x.size(), 0), is_other(is_cover.size(), 0);
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        const bool covers = bag.parts[static_cast<std::size_t>(bag.sheet.part[e])].title ==
                            std::string_view("module cover");
        for (const Index n : bag.sheet.cells[e]) (covers ? is_cover : is_other)[n] = 1;
    }
    for (std::size_t n = 0; n < is_cover.size(); ++n)
        if (is_cover[n] && !is_other[n])
            for (Points* at : {&bag.sheet.x, &bag.sheet.X}) (*at)[n].z() -= depth;
}

/// Slivers drawn together, but for places where layers would cross by it.
/// @param bag  before its corners are cut
/// @param cut  after that: what is left if nothing helps
Bag without_slivers(const Bag& bag, Panel panel, double size, Bag cut) {
    Points spots;
    const Freedom freedom{{}, [&](const Vec3& X) {
                              return std::none_of(spots.begin(), spots.end(), [&](const Vec3& s) {
                                  return (X - s).norm() < ROUND_CROSSING * size;
                              });
                          }};
    for (int k = 0; k < TRIES; ++k) {
        Bag tried = bag;
        if (collapse({TOO_SMALL * size, SLACK * size, sewn_nodes(bag)}, freedom, tried.sheet) == 0)
            return cut;
        drop_loose_nodes(tried.sheet, {&tried.seam, &tried.module});
        cut_corners_inward(panel, tried);
        const auto crossings = crossing_cells(tried.sheet);
        if (crossings.empty()) return tried;
        for (const auto& [a, b] : crossings)
            for (const Index cell : {a, b})
                for (const Index n : tried.sheet.cells[cell]) spots.push_back(tried.sheet.X[n]);
    }
    return cut;
}

/// Nodes of a panel within the spot, as the cloth lies flat.
std::vector<Index> nodes_of(const Spot& spot, const char* name, const Recipe& recipe,
                            const Bag& bag) {
    const Panel panel = spot.is_front ? Panel::FRONT : Panel::BACK;
    std::set<Index> nodes;
    double nearest = INF;
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        if (!is_of(panel, bag, e)) continue;
        for (const Index n : bag.sheet.cells[e]) {
            const Vec3& X = bag.sheet.X[n];
            const double away = std::hypot(X.x() - spot.x, X.y() - spot.y);
            nearest = std::min(nearest, away);
            if (away <= 0.5 * spot.diameter) nodes.insert(n);
        }
    }
    if (nodes.empty())
        throw InputError(fmt::format(
            "{}:{}: {} of diameter {:g} at ({:g}, {:g}) holds no node of the {} panel: the nearest "
            "is {:.4g} away, expected a diameter above {:.4g}",
            recipe.file, spot.line, name, spot.diameter, spot.x, spot.y,
            spot.is_front ? "front" : "back", nearest, 2.0 * nearest));
    return {nodes.begin(), nodes.end()};
}

void mark_spots(const Recipe& recipe, Bag& bag) {
    if (recipe.inflator) bag.module = nodes_of(*recipe.inflator, "[inflator]", recipe, bag);
    std::set<Index> clamped;
    for (const Spot& clamp : recipe.clamps) {
        const std::vector<Index> nodes = nodes_of(clamp, "[[clamp]]", recipe, bag);
        clamped.insert(nodes.begin(), nodes.end());
    }
    bag.clamped.assign(clamped.begin(), clamped.end());
}

/// The first way that does not cross, or the first.
Bag best_of(const Recipe& recipe, const std::vector<Move>& folds) {
    Bag first;
    const bool is_always_alike = recipe.vents.empty() && !recipe.hole;
    for (const auto& way : WAYS) {
        if (is_always_alike && !way.is_alike) continue;
        const Bag bag = fold_once(recipe, folds, way);
        for (const Panel panel : {Panel::BACK, Panel::FRONT}) {
            Bag cut = bag;
            const bool is_cut = cut_corners_inward(panel, cut);
            if (crossing_cells(cut.sheet).empty())
                return without_slivers(bag, panel, recipe.pattern.element, std::move(cut));
            if (first.sheet.x.empty()) first = std::move(cut);
            if (!is_cut) break;  // no corner: the other panel is no other way
        }
    }
    return first;
}

}  // namespace

Bag fold(const Recipe& recipe) {
    const std::vector<Move> folds =
        plan_folds(recipe, make_bag(recipe, {}).sheet.x, recipe.pattern.band);
    Bag best = best_of(recipe, folds);
    turn_front(best);
    if (recipe.hole && recipe.hole->depth > 0.0) press_dish(recipe.hole->depth, best);
    mark_spots(recipe, best);
    return best;
}

}  // namespace corpuscle::fold
