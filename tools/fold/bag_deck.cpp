// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "tools/fold/bag_deck.hpp"

#include <fmt/format.h>

#include <map>

#include "io/mesh/deck_writer.hpp"

namespace corpuscle::fold {
namespace {

std::string node_table(const char* keyword, const Points& x) {
    std::string text =
        fmt::format("{}\n$#   nid               x               y               z\n", keyword);
    for (std::size_t n = 0; n < x.size(); ++n)
        text += fmt::format("{:8d}{}{}{}\n", n + 1, io::in_16_columns(x[n].x() + 0.0),
                            io::in_16_columns(x[n].y() + 0.0), io::in_16_columns(x[n].z() + 0.0));
    return text;
}

std::string set(const char* keyword, int id, const char* title, const std::vector<int>& members) {
    if (members.empty()) return "";
    std::string text = fmt::format("{}\n{}\n{:10d}", keyword, title, id);
    for (std::size_t i = 0; i < members.size(); ++i)
        text += fmt::format("{}{:10d}", i % 8 == 0 ? "\n" : "", members[i]);
    return text + "\n";
}

std::vector<int> numbers(const std::vector<Index>& rows) {
    std::vector<int> all;
    for (const Index row : rows) all.push_back(row + 1);
    return all;
}

std::string comment(std::string text) {
    std::string all = "$ ";
    for (const char c : text) all += c == '\n' ? std::string("\n$ ") : std::string(1, c);
    return all + "\n";
}

}  // namespace

std::string bag_deck(const Bag& bag, const Recipe& recipe, const Inspection& found) {
    std::string deck =
        comment(recipe.title + "\nMade by corpuscle fold: change the recipe, not this.");
    if (!recipe.units.empty()) deck += comment("Units: " + recipe.units);
    deck += comment(text(found));
    std::map<int, std::string> titles;  // of the parts that there are
    for (const int row : bag.sheet.part) titles.emplace(bag.parts[row].id, bag.parts[row].title);
    std::vector<int> parts;
    for (const auto& [id, title] : titles) {
        parts.push_back(id);
        deck += comment(fmt::format("part {}: {}", id, title));
    }
    deck += "*KEYWORD\n" + node_table("*NODE", bag.sheet.x);
    deck += "*ELEMENT_SHELL\n$#   eid     pid      n1      n2      n3      n4\n";
    for (std::size_t e = 0; e < bag.sheet.cells.size(); ++e) {
        const Cell& c = bag.sheet.cells[e];
        deck +=
            fmt::format("{:8d}{:8d}{:8d}{:8d}{:8d}{:8d}\n", e + 1, bag.parts[bag.sheet.part[e]].id,
                        c[0] + 1, c[1] + 1, c[2] + 1, c[3] + 1);
    }
    deck += node_table("*AIRBAG_REFERENCE_GEOMETRY", bag.sheet.X);
    deck += set("*SET_PART_LIST_TITLE", 1, "the bag", parts);
    deck += set("*SET_PART_LIST_TITLE", 2, "vents",
                bag.has_vents ? std::vector{recipe.parts.vent} : std::vector<int>{});
    deck += set(
        "*SET_NODE_LIST_TITLE", 1,
        recipe.inflator ? "module: cloth about the inflator" : "module: cover and ring of the hole",
        numbers(bag.module));
    deck += set("*SET_NODE_LIST_TITLE", 2, "seam", numbers(bag.seam));
    deck += set("*SET_NODE_LIST_TITLE", 3, "clamped", numbers(bag.clamped));
    return deck + "*END\n";
}

}  // namespace corpuscle::fold
