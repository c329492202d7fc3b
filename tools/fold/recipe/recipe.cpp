// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/recipe/recipe.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

#include "solver/base/error.hpp"
#include "tools/fold/recipe/recipe_steps.hpp"
#include "tools/fold/recipe/toml_reader.hpp"

namespace corpuscle::fold {
namespace {

/// Of both panels: twenty times a large bag's.
constexpr double MOST_CELLS = 1e6;

/// A mesh must fit into the machine before it is made.
void check_cells(TableReader& at, const Pattern& p) {
    const bool is_disc = p.kind == PatternKind::DISC;
    const double area =
        is_disc ? 0.25 * std::numbers::pi * p.diameter * p.diameter : p.length * p.width;
    const double least = std::sqrt(2.0 * area / MOST_CELLS);
    if (p.element < 0.999 * least)  // what the message rounds is good enough
        at.fault("element",
                 fmt::format("{:.4g} or more, for {:.0f} cells in all at most", least, MOST_CELLS));
}

std::vector<int> read_parts_of(TableReader& at, const char* key) {
    std::vector<int> all;
    if (!at.has(key)) return all;
    for (const double id : at.numbers(key, 0, true)) {
        if (id != std::floor(id) || id > 99999999) at.fault(key, "part numbers");
        all.push_back(static_cast<int>(id));
    }
    return all;
}

void read_deck_pattern(TableReader& at, Pattern& p, const RecipeFaults& faults) {
    p.kind = PatternKind::DECK;
    const std::string file = at.text_or("file", "");
    if (file.empty()) at.fault("file", "the deck that holds the two panels");
    p.deck = std::filesystem::path(faults.file).parent_path() / file;
    p.front = read_parts_of(at, "front");
    p.back = read_parts_of(at, "back");
    if (p.front.empty() != p.back.empty())
        at.fault(p.front.empty() ? "front" : "back",
                 "part numbers, for the other panel's are given");
}

Pattern read_pattern(const toml::table& table, RecipeFaults& faults) {
    TableReader at(table, "[pattern]", faults);
    Pattern p;
    const std::string kind = at.choice("kind", {"disc", "rectangle", "deck"});
    if (kind == "disc") p.diameter = at.positive("diameter");
    if (kind == "rectangle") {
        p.kind = PatternKind::RECTANGLE;
        p.length = at.positive("length");
        p.width = at.positive("width");
    }
    if (kind == "deck") read_deck_pattern(at, p, faults);
    p.element = at.positive("element");
    p.gap = at.positive("gap");
    p.closing = at.positive_or("closing", 1.5 * p.element);
    p.band = at.positive_or("band", p.element);
    if (p.kind != PatternKind::DECK) check_cells(at, p);
    at.finish();
    return p;
}

PartIds read_parts(const toml::table& table, RecipeFaults& faults) {
    TableReader at(table, "[parts]", faults);
    PartIds p;
    const auto id = [&](const char* key, int& value) {
        value = at.whole_or(key, value, 1, 99999999);
    };
    id("front", p.front);
    id("back", p.back);
    id("module", p.module);
    id("reinforcement", p.reinforcement);
    id("vent", p.vent);
    id("tether", p.tether);
    at.finish();
    return p;
}

Hole read_hole(const toml::table& table, RecipeFaults& faults) {
    TableReader at(table, "[hole]", faults);
    Hole h;
    h.diameter = at.positive("diameter");
    h.reinforcement = at.not_negative_or("reinforcement", 0.0);
    if (h.reinforcement > 0.0 && h.reinforcement <= h.diameter)
        at.fault("reinforcement", "a diameter above that of the hole, or 0 for none");
    h.is_open = at.truth_or("open", false);
    h.depth = at.not_negative_or("depth", 0.0);
    if (h.is_open && h.depth > 0.0) at.fault("depth", "none for an open hole");
    at.finish();
    return h;
}

/// Where something round lies on a panel: of a vent, or of a spot.
template <class Round>
void read_circle(TableReader& at, Round& circle) {
    const std::vector<double> place = at.numbers("at", 2, false);
    circle.x = place[0];
    circle.y = place[1];
    circle.diameter = at.positive("diameter");
    circle.is_front = at.choice("panel", {"back", "front"}) == "front";
    at.finish();
}

VentHole read_vent(const toml::table& table, RecipeFaults& faults) {
    TableReader at(table, "[[vent]]", faults);
    VentHole v;
    read_circle(at, v);
    return v;
}

Spot read_spot(const toml::table& table, const char* name, RecipeFaults& faults) {
    TableReader at(table, name, faults);
    Spot s;
    s.line = static_cast<int>(at.line());
    read_circle(at, s);
    return s;
}

Tether read_tether(const toml::table& table, RecipeFaults& faults) {
    TableReader at(table, "[[tether]]", faults);
    Tether t;
    t.line = static_cast<int>(at.line());
    const std::vector<double> place = at.numbers("from", 2, false);
    t.x = place[0];
    t.y = place[1];
    t.direction = at.whole_or("direction", 0, 0, 270);
    if (t.direction % 90 != 0) at.fault("direction", "0, 90, 180 or 270 degrees");
    t.length = at.positive("length");
    t.width = at.positive("width");
    at.finish();
    return t;
}

Package read_package(const toml::table& table, RecipeFaults& faults) {
    TableReader at(table, "[package]", faults);
    const Package p{at.positive("length"), at.positive("width"), at.positive("height")};
    at.finish();
    return p;
}

Recipe read(const toml::table& root, const std::string& name) {
    RecipeFaults faults{name, {}};
    TableReader at(root, "the recipe", faults);
    Recipe r;
    r.file = name;
    r.title = at.text_or("title", r.title);
    r.units = at.text_or("units", "");
    if (const auto* table = at.table("pattern"))
        r.pattern = read_pattern(*table, faults);
    else if (!at.has("pattern"))
        at.fault("pattern", "a table [pattern]");
    if (const auto* table = at.table("parts")) r.parts = read_parts(*table, faults);
    if (const auto* table = at.table("hole")) r.hole = read_hole(*table, faults);
    if (const auto* table = at.table("package")) r.package = read_package(*table, faults);
    if (const auto* table = at.table("inflator"))
        r.inflator = read_spot(*table, "[inflator]", faults);
    if (r.inflator && r.hole)
        at.fault("inflator", "none: the [hole]'s cover is the inflator's place");
    for (const auto* table : at.tables("clamp"))
        r.clamps.push_back(read_spot(*table, "[[clamp]]", faults));
    for (const auto* table : at.tables("vent")) r.vents.push_back(read_vent(*table, faults));
    for (const auto* table : at.tables("tether")) r.tethers.push_back(read_tether(*table, faults));
    if (r.pattern.kind == PatternKind::DECK)
        for (const auto& [key, is_there] :
             {std::pair("hole", r.hole.has_value()), std::pair("vent", !r.vents.empty()),
              std::pair("tether", !r.tethers.empty())})
            if (is_there) at.fault(key, "none: a deck's panels have their own");
    int number = 0;
    for (const auto* table : at.tables("fold"))
        r.steps.push_back(read_step(*table, ++number, faults));
    at.finish();
    if (!faults.all.empty()) throw InputError(faults.all);
    return r;
}

}  // namespace

Recipe parse_recipe(const std::string& text, const std::string& name) {
    try {
        return read(toml::parse(text, name), name);
    } catch (const toml::parse_error& error) {
        throw InputError(fmt::format("{}:{}: {}", name, error.source().begin.line,
                                     std::string(error.description())));
    }
}

Recipe read_recipe(const std::filesystem::path& file) {
    std::ifstream in(file);
    std::ostringstream text;
    if (!in || !(text << in.rdbuf()))
        throw InputError(fmt::format("{}: cannot be read, or is empty", file.string()));
    return parse_recipe(text.str(), file.string());
}

}  // namespace corpuscle::fold
