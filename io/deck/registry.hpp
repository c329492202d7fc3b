// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "io/deck/faults.hpp"
#include "io/deck/included/id_kind.hpp"
#include "solver/base/vec.hpp"

namespace corpuscle::io {

/// Deck ids of one kind of thing -> its rows, and where each was defined.
class Registry {
public:
    struct Entry {
        Index row = -1;
        Place place;
        bool is_collected = false;  ///< _COLLECT: others of the id that are so add to it
    };

    explicit Registry(std::string_view kind, IdKind id_kind = IdKind::OTHER)
        : kind_(kind), id_kind_(id_kind) {}

    /// In the user's words: "*PART".
    [[nodiscard]] std::string_view kind() const { return kind_; }
    [[nodiscard]] IdKind id_kind() const { return id_kind_; }

    [[nodiscard]] const Entry* find(int id) const {
        const auto at = entries_.find(id);
        return at == entries_.end() ? nullptr : &at->second;
    }

    /// False when the id is taken; the first definition stays.
    bool add(int id, Index row, Place place) {
        return entries_.try_emplace(id, Entry{row, place}).second;
    }
    /// The same of a _COLLECT: where one of the id is there already, it is this one too, unless
    /// that is no _COLLECT. @returns the first definition
    const Entry& collect(int id, Index row, Place place) {
        return entries_.try_emplace(id, Entry{row, place, true}).first->second;
    }

    void reserve(std::size_t n) { entries_.reserve(n); }

    /// An id that the deck defines by a keyword that is refused: what refers to it is no further
    /// fault.
    void spoil(int id) { spoilt_.insert(id); }
    /// The same of all ids that nothing defines: some text of the deck could not be read.
    void spoil_rest() { rest_is_spoilt_ = true; }
    [[nodiscard]] bool is_spoilt(int id) const { return rest_is_spoilt_ || spoilt_.contains(id); }

    /// A definition that nothing acts on: only what refers to it is a fault.
    struct Unread {
        std::string keyword;  ///< without its star
        Place place;
    };
    void set_aside(int id, Unread definition) { unread_.try_emplace(id, std::move(definition)); }
    [[nodiscard]] const Unread* unread(int id) const {
        const auto at = unread_.find(id);
        return at == unread_.end() ? nullptr : &at->second;
    }

    /// Rows of the ids first, first + step, ... up to last that exist, by ascending id.
    [[nodiscard]] std::vector<Index> between(int first, int last, int step = 1) const {
        if (by_id_.size() != entries_.size()) {
            by_id_.clear();
            for (const auto& [id, entry] : entries_) by_id_.emplace_back(id, entry.row);
            std::sort(by_id_.begin(), by_id_.end());
        }
        std::vector<Index> rows;
        for (auto at = std::lower_bound(by_id_.begin(), by_id_.end(), std::pair(first, Index{-1}));
             at != by_id_.end() && at->first <= last; ++at)
            if ((at->first - first) % step == 0) rows.push_back(at->second);
        return rows;
    }

private:
    std::string_view kind_;
    IdKind id_kind_;
    std::unordered_map<int, Entry> entries_;
    std::unordered_set<int> spoilt_;
    std::unordered_map<int, Unread> unread_;
    bool rest_is_spoilt_ = false;
    mutable std::vector<std::pair<int, Index>> by_id_;
};

}  // namespace corpuscle::io
