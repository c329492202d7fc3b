// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "tools/fold/moves/move.hpp"

/// How a bag is cut and folded, as its recipe says. Lengths are in the recipe's own unit.
namespace corpuscle::fold {

enum class PatternKind { DISC, RECTANGLE, DECK };

struct Pattern {
    PatternKind kind = PatternKind::DISC;
    double diameter = NaN;             ///< of the disc                                        [m]
    double length = NaN, width = NaN;  ///< of the rectangle along x and y                     [m]
    std::filesystem::path deck;        ///< that holds the panels
    std::vector<int> front, back;      ///< its parts; both empty: told apart by height
    double element = NaN;              ///< size of the elements                               [m]
    double gap = NaN;                  ///< between layers, middle to middle                   [m]
    double closing = NaN;              ///< over which the panels close towards the seam       [m]
    double band = NaN;                 ///< least width of a bend on each side of its line     [m]
};

/// Part numbers. Those of things that the recipe has not are not used.
struct PartIds {
    int front = 1, back = 2, module = 3, reinforcement = 4, vent = 5, tether = 6;
};

/// The inflator's hole in the back panel, at the middle.
struct Hole {
    double diameter = NaN;
    double reinforcement = 0.0;  ///< outer diameter of the ring; 0: none                      [m]
    bool is_open = false;        ///< else covered by the part "module"
    double depth = 0.0;  ///< of the cover: a dish, with room for orifices                [m]
};

struct VentHole {
    double x = NaN, y = NaN, diameter = NaN;  ///< [m]
    bool is_front = false;
};

/// Nodes of a panel about a place: where the inflator sits, or what is clamped.
struct Spot {
    double x = NaN, y = NaN, diameter = NaN;  ///< in the flat cloth                         [m]
    bool is_front = false;
    int line = 0;  ///< of the recipe
};

/// A strip between the panels: sewn to the back where it begins and to the front where it ends.
struct Tether {
    double x = NaN, y = NaN;  ///< middle of its beginning                                     [m]
    int direction = 0;        ///< 0, 90, 180 or 270 degrees from x
    double length = NaN, width = NaN;
    int line = 0;  ///< of the recipe
};

struct Package {
    double length = NaN, width = NaN, height = NaN;  ///< along x, y, z                        [m]
};

/// One [[fold]]: moves that are done one after the other.
struct Step {
    std::string name;  ///< "fold 2 (zigzag)"
    std::vector<Move> moves;
};

struct Recipe {
    std::string file;
    std::string title = "folded bag";
    std::string units;  ///< for the deck's comment
    Pattern pattern;
    PartIds parts;
    std::optional<Hole> hole;
    std::vector<VentHole> vents;
    std::vector<Tether> tethers;
    std::optional<Spot> inflator;  ///< none with a hole, whose cover is the inflator's place
    std::vector<Spot> clamps;
    std::vector<Step> steps;
    std::optional<Package> package;
};

/// @throws InputError with every fault: file, line, table, key, value and what was expected
[[nodiscard]] Recipe read_recipe(const std::filesystem::path& file);
[[nodiscard]] Recipe parse_recipe(const std::string& text, const std::string& name);

}  // namespace corpuscle::fold
