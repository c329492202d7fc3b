// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <set>
#include <utility>
#include <vector>

#include "io/deck/card.hpp"
#include "io/model/draft.hpp"

/// What all *SET_ keywords have in common.
namespace corpuscle::io::keywords {

/// The header card. @returns the set's row: a new one, or with _COLLECT that of its id
std::size_t set_header(Cards& cards, Registry& sets, std::size_t new_row);

/// Ids of a line of _GENERAL. Attributes of segments stand in E4 to E7, so PART, SHELL and the sets
/// of them have three ids there.
inline constexpr std::size_t MOST_IDS = 7, MOST_SEGMENT_IDS = 3;

using Segments = std::vector<std::array<Index, 4>>;

/// Each item once, in the order of first mention.
template <class Item>
class Collection {
public:
    void add(const std::vector<Item>& items) {
        for (const Item& item : items)
            if (members_.insert(item).second) items_.push_back(item);
    }
    void remove(const std::vector<Item>& items) {
        for (const Item& item : items) members_.erase(item);
        std::erase_if(items_, [&](const Item& item) { return !members_.contains(item); });
    }
    [[nodiscard]] const std::vector<Item>& items() const { return items_; }
    /// The finished set; one without anything in it is a fault, unless another one explains it.
    std::vector<Item> close(Cards& cards) {
        if (items_.empty() && cards.good()) cards.fault("is empty, expected something in the set");
        return std::move(items_);
    }

private:
    std::vector<Item> items_;
    std::set<Item> members_;
};

/// Row of the set in `store` that a keyword defines or, with _COLLECT, adds to.
template <class Item>
std::size_t begin_set(Cards& cards, Registry& sets, std::vector<std::vector<Item>>& store) {
    const std::size_t row = set_header(cards, sets, store.size());
    if (row == store.size()) store.emplace_back();
    return row;
}

/// Puts what a keyword has brought behind what its set holds already.
template <class Item>
void end_set(Cards& cards, Collection<Item>& brought, std::vector<Item>& set) {
    Collection<Item> all;
    all.add(set);
    all.add(brought.close(cards));
    set = all.items();
}

}  // namespace corpuscle::io::keywords
