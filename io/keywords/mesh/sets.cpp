// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/mesh/sets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "io/keywords/keywords.hpp"

namespace corpuscle::io::keywords {

std::size_t set_header(Cards& cards, Registry& sets, std::size_t new_row) {
    if (cards.has("TITLE")) cards.title();
    Card c = cards.next("SID DA1 DA2 DA3 DA4 SOLVER ITS -");
    c.harmless("DA1 DA2 DA3 DA4 SOLVER ITS");
    if (cards.has("COLLECT"))
        return static_cast<std::size_t>(c.collected_row("SID", sets, new_row));
    c.new_id("SID", sets, new_row);
    return new_row;
}

namespace {

using Rows = std::vector<Index>;

/// Ids of a set that nothing of the deck has: one fault for all of them.
class MissingIds {
public:
    explicit MissingIds(const Registry& things) : things_(things) {}

    [[nodiscard]] bool has(int id) const {
        return things_.find(id) == nullptr && !things_.is_spoilt(id) &&
               things_.unread(id) == nullptr;
    }
    /// @param card, field  of the first one, from 1
    void add(int id, Place at, std::size_t card, std::size_t field) {
        if (ids_.empty()) {
            first_ = at;
            label_ = fmt::format(" card {}, field {} (ID{})", card, field, field);
        }
        ids_.push_back(id);
    }
    void tell(Cards& cards) const {
        if (ids_.empty()) return;
        constexpr std::ptrdiff_t FEW = 12;
        const std::ptrdiff_t count = std::ssize(ids_), shown = std::min(count, FEW);
        const std::string text =
            fmt::format(" = {}, expected the id of a {} of the deck{}{}{}", ids_[0], things_.kind(),
                        count > 1 ? ", nor are there " : "",
                        fmt::join(ids_.begin() + 1, ids_.begin() + shown, ", "),
                        count > FEW ? fmt::format(" and {} more", count - FEW) : "");
        cards.faults().fault(first_, fmt::format("*{}{}{}", cards.block().keyword, label_, text),
                             cards.block().keyword + text);
    }

private:
    const Registry& things_;
    std::vector<int> ids_;
    Place first_;
    std::string label_;
};

/// Eight ids a line.
Rows listed(Cards& cards, const Registry& things) {
    static const Layout layout("ID1 ID2 ID3 ID4 ID5 ID6 ID7 ID8");
    Rows rows;
    MissingIds missing(things);
    for (std::size_t card = cards.has("TITLE") ? 3 : 2; cards.rows(); ++card) {
        Card c = cards.next(layout);
        for (std::size_t i = 0; i < 8; ++i) {
            if (!c.given(i)) continue;
            const int id = c.id(i, things.id_kind());
            if (id == 0) continue;
            if (missing.has(id))
                missing.add(id, c.place(), card, i + 1);
            else if (const Index row = c.row(i, things); row >= 0)
                rows.push_back(row);
        }
    }
    missing.tell(cards);
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
            const int begin = c.id(i, things.id_kind()), end = c.id(i + 1, things.id_kind());
            if (c.good() && last < first)
                c.fault(i + 1, "an id that is not below the one before it");
            else if (c.good() && last > 0)
                append(rows, things.between(first > 0 ? begin : end - last, end));
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
        const double low = c.integer("BBEG", {1.0});
        const int first = c.id("BBEG", things.id_kind());
        const int last = c.id("BEND", things.id_kind(), {low});
        const int step = c.integer("INCR", {1.0});
        if (c.good()) append(rows, things.between(first, last, step));
    }
    return rows;
}

void list_set(Cards& cards, Registry& sets, std::vector<Rows>& store, const Registry& things) {
    const std::size_t row = begin_set(cards, sets, store);
    Rows rows = cards.has("COLUMN")      ? column(cards, things)
                : cards.has("INCREMENT") ? stepped(cards, things)
                : cards.has("GENERATE")  ? generated(cards, things)
                                         : listed(cards, things);
    Collection<Index> set;
    set.add(rows);
    end_set(cards, set, store[row]);
}

/// Eight ids of sets a line; below 0: all from the id before up to this one.
Rows listed_sums(Cards& cards, const Registry& sets) {
    static const Layout layout("ID1 ID2 ID3 ID4 ID5 ID6 ID7 ID8");
    Rows rows;
    int before = 0;
    while (cards.rows()) {
        Card c = cards.next(layout);
        for (std::size_t i = 0; i < 8; ++i) {
            const int id = c.given(i) ? c.id(i, sets.id_kind()) : 0;
            if (id < 0 && !(before > 0 && -id >= before))
                c.fault(i, "the id of a set, or minus one that is not below the id before it");
            else if (id < 0)
                append(rows, sets.between(before, -id));
            else if (id > 0)
                if (const Index row = c.row(i, sets); row >= 0) rows.push_back(row);
            if (id != 0) before = id;
        }
    }
    return rows;
}

/// The sum of other sets of the kind.
template <class Item>
void sum_set(Cards& cards, Registry& sets, std::vector<std::vector<Item>>& store) {
    const std::size_t row = begin_set(cards, sets, store);
    Collection<Index> parts;
    parts.add(listed_sums(cards, sets));
    Collection<Item> sum;
    for (const Index part : parts.close(cards)) sum.add(store[static_cast<std::size_t>(part)]);
    end_set(cards, sum, store[row]);
}

/// What all of some other sets of the kind have.
template <class Item>
void common_set(Cards& cards, Registry& sets, std::vector<std::vector<Item>>& store) {
    const std::size_t row = begin_set(cards, sets, store);
    Collection<Index> rows;
    rows.add(listed(cards, sets));
    const std::vector<Index> of = rows.close(cards);
    std::map<Item, std::size_t> count;
    for (const Index set : of)
        for (const Item& item : store[static_cast<std::size_t>(set)]) ++count[item];
    Collection<Item> common;
    for (const Index set : of)
        for (const Item& item : store[static_cast<std::size_t>(set)])
            if (count[item] == of.size()) common.add({item});
    end_set(cards, common, store[row]);
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
    const std::size_t row = begin_set(cards, draft.segment_sets, draft.segment_set);
    Segments segments;
    while (cards.rows()) {
        Card c = cards.next(layout);
        c.harmless("A1 A2 A3 A4");
        std::array<Index, 4> nodes{};
        for (std::size_t k = 0; k < 3; ++k) nodes[k] = c.row(k, draft.nodes);
        const Index fourth = c.row_or_none("N4", draft.nodes);
        nodes[3] = fourth < 0 ? nodes[2] : fourth;
        segments.push_back(c.file().facet(nodes));
    }
    Collection<std::array<Index, 4>> set;
    set.add(segments);
    end_set(cards, set, draft.segment_set[row]);
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
void set_node_intersect(Cards& cards, Draft& d) {
    common_set(cards, d.node_sets, d.node_set);
}
void set_shell_intersect(Cards& cards, Draft& d) {
    common_set(cards, d.shell_sets, d.shell_set);
}
void set_segment_intersect(Cards& cards, Draft& d) {
    common_set(cards, d.segment_sets, d.segment_set);
}

}  // namespace corpuscle::io::keywords
