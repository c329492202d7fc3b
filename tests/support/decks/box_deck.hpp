// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "solver/base/vec.hpp"

/// Keyword decks of boxes that tests write. SI units.
namespace corpuscle::test {

/// Nodes and shells of a deck; ids count from 1.
struct DeckMesh {
    struct Quad {
        int part;
        std::array<int, 4> nodes;  ///< ids; a triangle repeats its third
    };
    std::vector<Vec3> nodes;
    std::vector<Quad> quads;

    /// Nodes, shells, and set 1 of the nodes with is_held.
    [[nodiscard]] std::string cards(const std::function<bool(const Vec3&)>& is_held) const;
};

/// A box from the origin to `size` of cells[0] × cells[1] × cells[2] quads, with walls across x.
struct BoxDeck {
    Vec3 size;
    std::array<int, 3> cells;
    /// Part of a quad of the hull, by its centre.
    std::function<int(const Vec3& centre)> part;
    std::map<int, int> membranes;  ///< place [cells along x] -> part
    /// Whose nodes are free; none: all are held.
    std::function<bool(const Vec3&)> is_free;

    [[nodiscard]] DeckMesh mesh() const;
    [[nodiscard]] bool is_held(const Vec3& x) const { return !is_free || !is_free(x); }
};

/// *DEFINE_CURVE of (abscissa, ordinate) pairs.
std::string curve_card(int id, const std::vector<std::array<double, 2>>& points);
/// *DEFINE_CURVE: 0 before `time`, `value` from then on.
std::string step_card(int id, double time, double value);
/// *SET_PART_LIST
std::string set_card(int id, const std::vector<int>& parts);
/// *PART of section 1
std::string part_card(int id, int material, int section = 1);
/// *SECTION_SHELL, membrane
std::string section_card(int id, double thickness);
/// *NODE at `x`
std::string node_card(int id, const Vec3& x);

/// *KEYWORD, TITLE, the mesh with its nodes held, `cards`, the end and the histories' interval.
std::string box_deck(const std::string& title, const BoxDeck& box, const std::string& cards,
                     double end, double sample);

}  // namespace corpuscle::test
