// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/recipe/recipe_steps.hpp"

#include <fmt/format.h>

#include <numbers>

namespace corpuscle::fold {
namespace {

constexpr int MOST_FOLDS = 1000;

/// half: one line; what is beyond it is turned onto the rest.
std::vector<Move> read_half(TableReader& at, Accordion fold) {
    fold.lines = {at.real_or("at", 0.0)};
    return {fold};
}

/// zigzag: from `start` on, pleats of the widths given, the last as wide as the cloth goes on; or
/// as many pleats of one width as there is cloth, at most `count`.
std::vector<Move> read_zigzag(TableReader& at, Accordion fold, bool is_both) {
    double line = is_both ? at.not_negative_or("start", 0.0) : at.real_or("start", 0.0);
    if (is_both) fold.room = line;
    fold.lines = {line};
    if (at.has("pleats")) {
        for (const double width : at.numbers("pleats", 0, true))
            fold.lines.push_back(line += width);
        fold.needed = fold.lines.size();
    } else {
        const double width = at.positive("width");
        for (int i = at.whole_or("count", MOST_FOLDS, 1, MOST_FOLDS); i > 0; --i)
            fold.lines.push_back(line += width);
        if (at.has("count")) fold.needed = fold.lines.size();
    }
    return {fold};
}

/// roll: a half fold after the other, each `width` further in than the last.
std::vector<Move> read_roll(TableReader& at, Accordion fold) {
    const double width = at.positive("width"), start = at.real("start");
    std::vector<Move> all;
    for (int i = 0, n = at.whole_or("count", 1, 1, MOST_FOLDS); i < n; ++i) {
        fold.lines = {start - i * width};
        all.push_back(fold);
    }
    return all;
}

/// tuck: what is beyond `at` is pushed in between the panels.
std::vector<Move> read_tuck(TableReader& at, const Accordion& fold, bool is_both) {
    Tuck tuck;
    tuck.angle = fold.angle;
    tuck.is_left = fold.is_left;
    tuck.name = fold.name;
    tuck.line = is_both ? at.positive("at") : at.real("at");
    if (is_both) tuck.room = 0.0;
    if (at.has("onto")) at.fault("onto", "none: a tuck lies between the panels");
    return {tuck};
}

/// The same on the other side, after the first.
void add_other_side(std::vector<Move>& all) {
    const std::size_t n = all.size();
    for (std::size_t i = 0; i < n; ++i) {
        all.push_back(all[i]);
        std::visit([](auto& fold) { fold.is_left = !fold.is_left; }, all.back());
    }
}

}  // namespace

Step read_step(const toml::table& table, int number, RecipeFaults& faults) {
    TableReader at(table, "[[fold]]", faults);
    const std::string kind = at.choice("kind", {"half", "zigzag", "roll", "tuck"});
    if (!at.has("kind")) at.fault("kind", "one of \"half\", \"zigzag\", \"roll\", \"tuck\"");
    const std::string side = at.choice("side", {"right", "left", "both"});
    Accordion fold;
    fold.name = fmt::format("{}:{}: fold {} ({})", faults.file, at.line(), number, kind);
    fold.angle = at.real_or("angle", 0.0) * std::numbers::pi / 180.0;
    fold.is_down = at.choice("onto", {"front", "back"}) == "back";
    fold.is_left = side == "left";

    Step step{fmt::format("fold {} ({})", number, kind), {}};
    if (kind == "half") {
        if (side == "both") at.fault("side", "right or left for a half fold");
        step.moves = read_half(at, fold);
    } else if (kind == "zigzag") {
        step.moves = read_zigzag(at, fold, side == "both");
    } else if (kind == "roll") {
        step.moves = read_roll(at, fold);
    } else {
        step.moves = read_tuck(at, fold, side == "both");
    }
    if (side == "both") add_other_side(step.moves);
    at.finish();
    return step;
}

}  // namespace corpuscle::fold
