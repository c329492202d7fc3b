// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/sets.hpp"

#include <array>
#include <unordered_set>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

void set_header(Cards& cards, Registry& sets, std::size_t row) {
    if (cards.has("TITLE")) cards.title();
    Card c = cards.next("SID DA1 DA2 DA3 DA4 SOLVER ITS -");
    c.new_id("SID", sets, row);
    c.harmless("DA1 DA2 DA3 DA4 SOLVER ITS");
}

void close_set(Cards& cards, std::vector<Index>& items) {
    std::unordered_set<Index> seen;
    std::erase_if(items, [&](Index item) { return !seen.insert(item).second; });
    if (items.empty()) cards.fault("is empty, expected something in the set");
}

void close_set(Cards& cards, Segments& items) {
    if (items.empty()) cards.fault("is empty, expected something in the set");
}

namespace {

using Rows = std::vector<Index>;

/// Eight ids a line.
Rows listed(Cards& cards, const Registry& things) {
    static const Layout layout("ID1 ID2 ID3 ID4 ID5 ID6 ID7 ID8");
    Rows rows;
    while (cards.rows()) {
        Card c = cards.next(layout);
        for (std::size_t i = 0; i < 8; ++i)
            if (c.given(i) && c.integer(i) != 0)
                if (const Index row = c.row(i, things); row >= 0) rows.push_back(row);
    }
    return rows;
}

/// One id a line, with attributes.
Rows column(Cards& cards, const Registry& things) {
    static const Layout layout("ID A1 A2 A3 A4");
    Rows rows;
    while (cards.rows()) {
        Card c = cards.next(layout);
        c.harmless("A1 A2 A3 A4");
        if (const Index row = c.row("ID", things); row >= 0) rows.push_back(row);
    }
    return rows;
}

void append(Rows& rows, const Rows& more) {
    rows.insert(rows.end(), more.begin(), more.end());
}

/// Ids from BBEG to BEND that exist, up to four ranges a line.
Rows generated(Cards& cards, const Registry& things) {
    static const Layout layout("B1BEG B1END B2BEG B2END B3BEG B3END B4BEG B4END");
    Rows rows;
    while (cards.rows()) {
        Card c = cards.next(layout);
        for (std::size_t i = 0; i < 8; i += 2) {
            const int first = c.integer(i, NON_NEGATIVE), last = c.integer(i + 1, NON_NEGATIVE);
            if (c.good() && last < first)
                c.fault(i + 1, "an id that is not below the one before it");
            else if (c.good() && last > 0)
                append(rows, things.between(first, last));
        }
    }
    return rows;
}

/// The same with a step, one range a line.
Rows stepped(Cards& cards, const Registry& things) {
    static const Layout layout("BBEG BEND INCR=1");
    Rows rows;
    while (cards.rows()) {
        Card c = cards.next(layout);
        const int first = c.integer("BBEG", {1.0});
        const int last = c.integer("BEND", {static_cast<double>(first)});
        const int step = c.integer("INCR", {1.0});
        if (c.good()) append(rows, things.between(first, last, step));
    }
    return rows;
}

void list_set(Cards& cards, Registry& sets, std::vector<Rows>& store, const Registry& things) {
    set_header(cards, sets, store.size());
    Rows rows = cards.has("COLUMN")      ? column(cards, things)
                : cards.has("INCREMENT") ? stepped(cards, things)
                : cards.has("GENERATE")  ? generated(cards, things)
                                         : listed(cards, things);
    close_set(cards, rows);
    store.push_back(std::move(rows));
}

/// The sum of other sets of the kind.
template <class Set>
void sum_set(Cards& cards, Registry& sets, std::vector<Set>& store) {
    const Registry before = sets;  // a set does not contain itself
    set_header(cards, sets, store.size());
    Set sum;
    for (const Index set : listed(cards, before)) {
        const Set& part = store[static_cast<std::size_t>(set)];
        sum.insert(sum.end(), part.begin(), part.end());
    }
    close_set(cards, sum);
    store.push_back(std::move(sum));
}

}  // namespace

void set_node(Cards& cards, Draft& d) {
    list_set(cards, d.node_sets, d.node_set, d.nodes);
}
void set_part(Cards& cards, Draft& d) {
    list_set(cards, d.part_sets, d.part_set, d.parts);
}
void set_shell(Cards& cards, Draft& d) {
    list_set(cards, d.shell_sets, d.shell_set, d.shells);
}

void set_segment(Cards& cards, Draft& draft) {
    static const Layout layout("N1 N2 N3 N4 A1 A2 A3 A4");
    set_header(cards, draft.segment_sets, draft.segment_set.size());
    Segments segments;
    while (cards.rows()) {
        Card c = cards.next(layout);
        c.harmless("A1 A2 A3 A4");
        std::array<Index, 4> nodes{};
        for (std::size_t k = 0; k < 3; ++k) nodes[k] = c.row(k, draft.nodes);
        const Index fourth = c.row_or_none("N4", draft.nodes);
        nodes[3] = fourth < 0 ? nodes[2] : fourth;
        segments.push_back(nodes);
    }
    close_set(cards, segments);
    draft.segment_set.push_back(std::move(segments));
}

void set_node_add(Cards& cards, Draft& d) {
    sum_set(cards, d.node_sets, d.node_set);
}
void set_part_add(Cards& cards, Draft& d) {
    sum_set(cards, d.part_sets, d.part_set);
}
void set_shell_add(Cards& cards, Draft& d) {
    sum_set(cards, d.shell_sets, d.shell_set);
}
void set_segment_add(Cards& cards, Draft& d) {
    sum_set(cards, d.segment_sets, d.segment_set);
}

}  // namespace corpuscle::io::keywords
