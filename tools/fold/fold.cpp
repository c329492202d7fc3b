// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/fold.hpp"

#include <algorithm>

#include "tools/fold/imprint.hpp"

namespace corpuscle::fold {
namespace {

constexpr double SNAP = 0.35;  ///< of an edge, that a node moves to a fold's border at most
constexpr int FIRST_NAME = 2000000;

/// All accordions, with the bands that the draft needs.
std::vector<Accordion> plan_folds(const Recipe& r, Points x, double size) {
    std::vector<Accordion> all;
    for (const Step& step : r.steps)
        for (Accordion fold : step.accordions) {
            choose_bands(fold, x, r.pattern.gap, size);
            apply(fold, r.pattern.gap, x);
            all.push_back(fold);
        }
    return all;
}

/// Quads are cut into triangles from their first corner to their third: so that those which lie on
/// each other are cut alike, that one is chosen which rises in the plan of the pack.
void align_diagonals(Sheet& sheet) {
    for (Cell& c : sheet.cells) {
        if (corner_count(c) == 3) continue;
        const Vec3 d = sheet.x[c[2]] - sheet.x[c[0]];
        if (d.x() * d.y() < 0.0) std::rotate(c.begin(), c.begin() + 1, c.end());
    }
}

}  // namespace

Bag fold(const Recipe& recipe) {
    const double size = recipe.pattern.element;
    const std::vector<Accordion> folds = plan_folds(recipe, make_bag(recipe, {}).sheet.x, size);
    Bag bag = make_bag(recipe, plan_lines(folds));
    int name = FIRST_NAME;
    for (const Accordion& fold : folds) {
        for (const double border : borders(fold))
            imprint(bag.sheet, {name++, distance(fold, border, bag.sheet.x), SNAP, {}});
        apply(fold, recipe.pattern.gap, bag.sheet.x);
    }
    turn_front(bag);
    align_diagonals(bag.sheet);
    return bag;
}

}  // namespace corpuscle::fold
