// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/fold.hpp"

#include <algorithm>

#include "tools/fold/imprint.hpp"
#include "tools/fold/inspect.hpp"

namespace corpuscle::fold {
namespace {

/// How a mesh is made for the folds. Where the bends of oblique folds meet, facets are twisted, and
/// meshes of layers that do not match may come too close: then another mesh helps, or a finer one.
struct Way {
    double snap;  ///< share of an edge that a node moves to a fold's border at most
    int parts;    ///< of a band
};
constexpr std::array WAYS{Way{0.35, 1}, Way{0.25, 1}, Way{0.35, 2}, Way{0.25, 2}, Way{0.3, 3}};
/// Nodes on other lines that are nearer to a border than this share of an edge count as on it:
/// slivers would be worse.
constexpr double GIVES_WAY = 0.08;
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

/// The panel's other cell at an edge; -1: none.
Index neighbour(Panel panel, const Bag& bag, std::size_t cell, std::pair<Index, Index> edge) {
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        if (e == cell || !is_of(panel, bag, e)) continue;
        const auto all = edges({bag.sheet.cells[e]});
        if (std::find(all.begin(), all.end(), edge) != all.end()) return static_cast<Index>(e);
    }
    return -1;
}

/// An ear is a triangle with all its nodes on the seam. An edge of it that is not the seam, with a
/// node beyond that is not on it either, gives way to one from the corner to there.
/// @returns  was there such an edge?
bool cut_ear(Panel panel, const std::vector<char>& is_sewn, std::size_t e, Bag& bag) {
    const Cell ear = bag.sheet.cells[e];
    for (std::size_t i = 0; i < 3; ++i) {
        const Index a = ear[i], b = ear[(i + 1) % 3], corner = ear[(i + 2) % 3];
        const Index beyond = neighbour(panel, bag, e, {std::min(a, b), std::max(a, b)});
        if (beyond < 0) continue;  // the seam
        Cell c = bag.sheet.cells[static_cast<std::size_t>(beyond)];
        const int count = corner_count(c);
        std::rotate(c.begin(), std::find(c.begin(), c.begin() + count, b), c.begin() + count);
        const Index d = c[2], f = c[3];  // c is b a d or b a d f
        const bool is_inner = !is_sewn[d];
        if (!is_inner && (count == 3 || is_sewn[f])) continue;
        bag.sheet.cells[e] = is_inner ? Cell{corner, a, d, d} : Cell{corner, f, b, b};
        Cell& rest = bag.sheet.cells[static_cast<std::size_t>(beyond)];
        if (count == 3)
            rest = {corner, d, b, b};
        else
            rest = is_inner ? Cell{corner, d, f, b} : Cell{corner, a, d, f};
        return true;
    }
    return false;
}

/// A rectangle's corner is a quad with three nodes on the seam, or, where a line crosses it, an
/// ear. Cut alike in both panels they would have that cut in common, an edge where four facets
/// meet: in one panel it goes from the corner inward.
/// @returns  was there any?
bool cut_corners_inward(Panel panel, Bag& bag) {
    const std::vector<char> is_sewn = sewn_nodes(bag);
    bool is_cut = false;
    for (Cell& c : bag.sheet.cells)
        if (is_of(panel, bag, static_cast<std::size_t>(&c - bag.sheet.cells.data())) &&
            corner_count(c) == 4 && is_sewn[c[0]] && is_sewn[c[2]]) {
            std::rotate(c.begin(), c.begin() + 1, c.end());
            is_cut = true;
        }
    for (bool goes_on = true; goes_on;) {  // ears behind ears come into reach one by one
        goes_on = false;
        for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
            const Cell& c = bag.sheet.cells[e];
            if (corner_count(c) == 3 && is_sewn[c[0]] && is_sewn[c[1]] && is_sewn[c[2]] &&
                is_of(panel, bag, e) && cut_ear(panel, is_sewn, e, bag))
                goes_on = is_cut = true;
        }
    }
    return is_cut;
}

Bag fold_once(const Recipe& recipe, const std::vector<Move>& folds, Way way) {
    const double gap = recipe.pattern.gap;
    Bag bag = make_bag(recipe, plan_lines(folds, gap, way.parts));
    int name = FIRST_NAME;
    const auto do_move = [&](const auto& fold) {
        for (const double border : borders(fold, way.parts))
            imprint(bag.sheet,
                    {name++, distance(fold, border, bag.sheet.x), way.snap, GIVES_WAY, {}});
        turn_diagonals(fold, bag.sheet);
        apply(fold, gap, bag.sheet.x);
    };
    for (const Move& move : folds) std::visit(do_move, move);
    turn_front(bag);
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

/// The first way that does not cross, or the first.
Bag best_of(const Recipe& recipe, const std::vector<Move>& folds) {
    Bag first;
    for (const auto& way : WAYS) {
        const Bag bag = fold_once(recipe, folds, way);
        for (const Panel panel : {Panel::BACK, Panel::FRONT}) {
            Bag cut = bag;
            const bool is_cut = cut_corners_inward(panel, cut);
            if (crossing_cells(cut.sheet).empty()) return cut;
            if (first.sheet.x.empty()) first = std::move(cut);
            if (!is_cut) break;  // no corner: the other panel is no other way
        }
    }
    return first;
}

}  // namespace

Bag fold(const Recipe& recipe) {
    const std::vector<Move> folds =
        plan_folds(recipe, make_bag(recipe, {}).sheet.x, recipe.pattern.element);
    Bag best = best_of(recipe, folds);
    if (recipe.hole && recipe.hole->depth > 0.0) press_dish(recipe.hole->depth, best);
    return best;
}

}  // namespace corpuscle::fold
