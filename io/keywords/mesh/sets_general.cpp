// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

#include "io/keywords/keywords.hpp"
#include "io/keywords/mesh/sets.hpp"
#include "io/text/text.hpp"

/// *SET_..._GENERAL: lines of an option and ids, that add to the set or take away from it in turn.
namespace corpuscle::io::keywords {

namespace {

using Rows = std::vector<Index>;

Rows all_rows(std::size_t n) {
    Rows rows(n);
    std::iota(rows.begin(), rows.end(), 0);
    return rows;
}

/// Rows of the shells of a part.
Rows shells_of(const Draft& draft, Index part) {
    Rows rows;
    for (std::size_t i = 0; i < draft.model.shells.size(); ++i)
        if (draft.model.shells[i].part == part) rows.push_back(static_cast<Index>(i));
    return rows;
}

Rows nodes_of_shells(const Draft& draft, const Rows& shells) {
    Rows nodes;
    for (const Index s : shells)
        for (const Index node : draft.model.shells[static_cast<std::size_t>(s)].nodes)
            if (node >= 0) nodes.push_back(node);  // none: a shell with faults
    return nodes;
}

/// As the nodes are written, before *NODE_TRANSFORM.
Rows nodes_in(const Draft& draft, const SetBox& box) {
    Rows nodes;
    for (std::size_t n = 0; n < draft.model.x.size(); ++n)
        if (box.contains(draft.model.x[n])) nodes.push_back(static_cast<Index>(n));
    return nodes;
}

Segments segments_of(const Draft& draft, const Rows& shells) {
    Segments segments;
    for (const Index s : shells)
        segments.push_back(draft.model.shells[static_cast<std::size_t>(s)].nodes);
    return segments;
}

const Rows& at(const std::vector<Rows>& sets, Index row) {
    return sets[static_cast<std::size_t>(row)];
}

/// What an option's ids stand for: the items of each id, in terms of the set.
template <class Item>
struct Option {
    std::string_view name;  ///< a D in front takes away
    const Registry* ids;    ///< nullptr: no ids, ALL
    std::function<std::vector<Item>(Index)> items;

    [[nodiscard]] bool is(std::string_view written) const { return written == name; }
    [[nodiscard]] bool is_taken_away(std::string_view written) const {
        return ids != nullptr && written == fmt::format("D{}", name);
    }
};
template <class Item>
using Options = std::vector<Option<Item>>;

template <class Item>
const Option<Item>* find_option(Card& c, const Options<Item>& options) {
    const std::string written = upper(c.raw(0));
    std::string known;
    for (const Option<Item>& option : options) {
        if (option.is(written) || option.is_taken_away(written)) return &option;
        known.append(known.empty() ? "" : ", ").append(option.name);
    }
    c.harmless_all();
    c.fault("OPTION", fmt::format("one of {}, or all but ALL with D before it", known));
    return nullptr;
}

template <class Item>
Collection<Item> chosen(Card& c, const Option<Item>& option, std::size_t most_ids) {
    Collection<Item> items;
    if (option.ids == nullptr) items.add(option.items(0));
    for (std::size_t i = 1; option.ids != nullptr && i <= most_ids; ++i)
        if (c.given(i) && c.integer(i) != 0)
            if (const Index row = c.row(i, *option.ids); row >= 0) items.add(option.items(row));
    c.harmless("E4 E5 E6 E7");
    return items;
}

template <class Item>
void general_set(Cards& cards, Registry& sets, std::vector<std::vector<Item>>& store,
                 std::size_t most_ids, const Options<Item>& options) {
    static const Layout layout("OPTION E1 E2 E3 E4 E5 E6 E7");
    const std::size_t row = begin_set(cards, sets, store);
    Collection<Item> set;
    while (cards.rows()) {
        Card c = cards.next(layout);
        const Option<Item>* option = find_option(c, options);
        if (option == nullptr) continue;
        if (option->is_taken_away(upper(c.raw(0))))
            set.remove(chosen(c, *option, MOST_IDS).items());
        else
            set.add(chosen(c, *option, most_ids).items());
    }
    end_set(cards, set, store[row]);
}

}  // namespace

void set_node_general(Cards& cards, Draft& d) {
    general_set<Index>(
        cards, d.node_sets, d.node_set, MOST_IDS,
        {{"ALL", nullptr, [&](Index) { return all_rows(d.model.x.size()); }},
         {"NODE", &d.nodes, [](Index node) { return Rows{node}; }},
         {"PART", &d.parts, [&](Index part) { return nodes_of_shells(d, shells_of(d, part)); }},
         {"BOX", &d.boxes,
          [&](Index box) { return nodes_in(d, d.box[static_cast<std::size_t>(box)]); }},
         {"SET", &d.node_sets, [&](Index set) { return at(d.node_set, set); }},
         {"SET_SHELL", &d.shell_sets,
          [&](Index set) { return nodes_of_shells(d, at(d.shell_set, set)); }}});
}

void set_part_general(Cards& cards, Draft& d) {
    general_set<Index>(cards, d.part_sets, d.part_set, MOST_IDS,
                       {{"ALL", nullptr, [&](Index) { return all_rows(d.model.parts.size()); }},
                        {"PART", &d.parts, [](Index part) { return Rows{part}; }},
                        {"SET", &d.part_sets, [&](Index set) { return at(d.part_set, set); }}});
}

void set_shell_general(Cards& cards, Draft& d) {
    general_set<Index>(cards, d.shell_sets, d.shell_set, MOST_IDS,
                       {{"ALL", nullptr, [&](Index) { return all_rows(d.model.shells.size()); }},
                        {"ELEM", &d.shells, [](Index shell) { return Rows{shell}; }},
                        {"PART", &d.parts, [&](Index part) { return shells_of(d, part); }},
                        {"SET", &d.shell_sets, [&](Index set) { return at(d.shell_set, set); }}});
}

void set_segment_general(Cards& cards, Draft& d) {
    const auto every_shell = [&](Index) { return segments_of(d, all_rows(d.model.shells.size())); };
    general_set<std::array<Index, 4>>(
        cards, d.segment_sets, d.segment_set, MOST_SEGMENT_IDS,
        {{"ALL", nullptr, every_shell},
         {"PART", &d.parts, [&](Index part) { return segments_of(d, shells_of(d, part)); }},
         {"SHELL", &d.shells, [&](Index shell) { return segments_of(d, {shell}); }},
         {"SET_SHELL", &d.shell_sets,
          [&](Index set) { return segments_of(d, at(d.shell_set, set)); }},
         {"SET", &d.segment_sets,
          [&](Index set) { return d.segment_set[static_cast<std::size_t>(set)]; }}});
}

}  // namespace corpuscle::io::keywords
