// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/mesh/set_order.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "io/keywords/mesh/sets.hpp"
#include "io/text/text.hpp"

namespace corpuscle::io::keywords {

namespace {

/// Kind and id.
using SetName = std::pair<Registry*, int>;

/// Ids of a kind, from the first to the last.
struct SetRange {
    Registry* kind = nullptr;
    int first = 0, last = 0;
};

struct SetOfSets {
    SetName name;
    std::vector<SetRange> of;
    std::vector<std::size_t> behind;  ///< places of those of them that are sets of sets
    std::vector<std::size_t> before;  ///< places of sets that are made of it
};

Registry& kind_of(const Task& task, DraftNames& names) {
    if (task.match.name.starts_with("SET_NODE")) return names.node_sets;
    if (task.match.name.starts_with("SET_PART")) return names.part_sets;
    return task.match.name.starts_with("SET_SHELL") ? names.shell_sets : names.segment_sets;
}

/// What a line of _GENERAL refers to: SET and SET_SHELL, or with D in front.
void add_named(Card& c, DraftNames& names, SetOfSets& set) {
    std::string option = upper(c.raw(0));
    const bool is_taken_away = option.starts_with('D');
    if (is_taken_away) option.erase(0, 1);
    if (option != "SET" && option != "SET_SHELL") return;
    Registry* kind = option == "SET" ? set.name.first : &names.shell_sets;
    const bool is_short = set.name.first == &names.segment_sets && !is_taken_away;
    for (std::size_t i = 1; i <= (is_short ? MOST_SEGMENT_IDS : MOST_IDS); ++i)
        if (c.given(i)) {
            const int id = c.id(i, kind->id_kind());
            set.of.push_back({kind, id, id});
        }
}

/// Ids of a line of a sum; one below 0 ends the range that the one before begins.
void add_listed(Card& c, SetOfSets& set) {
    for (std::size_t i = 0; i < 8; ++i) {
        if (!c.given(i)) continue;
        const int id = c.id(i, IdKind::SET);
        if (id < 0 && !set.of.empty())
            set.of.back().last = -id;
        else
            set.of.push_back({set.name.first, id, id});
    }
}

/// Names alone: whoever reads the set tells what is wrong with its cards.
SetOfSets names_in(const Task& task, const Parameters& parameters, DraftNames& names) {
    static const Layout listed("ID1 ID2 ID3 ID4 ID5 ID6 ID7 ID8"),
        general("OPTION E1 E2 E3 E4 E5 E6 E7");
    Faults untold;
    Cards cards(*task.block, untold, parameters, task.match.suffixes);
    if (cards.has("TITLE")) cards.title();
    SetOfSets set;
    set.name = {&kind_of(task, names), cards.next("SID").id("SID", IdKind::SET)};
    const bool is_general = task.match.name.ends_with("_GENERAL");
    while (cards.rows()) {
        Card c = cards.next(is_general ? general : listed);
        if (is_general)
            add_named(c, names, set);
        else
            add_listed(c, set);
    }
    return set;
}

void find_uses(std::vector<SetOfSets>& sets) {
    std::map<SetName, std::vector<std::size_t>> places;  // several of a _COLLECT
    for (std::size_t i = 0; i < sets.size(); ++i) places[sets[i].name].push_back(i);
    for (std::size_t i = 0; i < sets.size(); ++i)
        for (const SetRange& of : sets[i].of)
            for (auto at = places.lower_bound({of.kind, std::max(of.first, 1)});
                 at != places.end() && at->first <= SetName(of.kind, of.last); ++at)
                for (const std::size_t place : at->second) {
                    sets[i].behind.push_back(place);
                    sets[place].before.push_back(i);
                }
}

/// Places in an order that works, the deck's own where it does; without those of circles.
std::vector<std::size_t> order_of(const std::vector<SetOfSets>& sets) {
    std::vector<std::size_t> waits(sets.size()), order;
    std::set<std::size_t> ready;
    for (std::size_t i = 0; i < sets.size(); ++i)
        if ((waits[i] = sets[i].behind.size()) == 0) ready.insert(i);
    while (!ready.empty()) {
        const std::size_t next = *ready.begin();
        ready.erase(ready.begin());
        order.push_back(next);
        for (const std::size_t user : sets[next].before)
            if (--waits[user] == 0) ready.insert(user);
    }
    return order;
}

/// A fault for each circle. @param left  sets in a circle or made of one
void tell_circles(const std::vector<SetOfSets>& sets, const std::vector<bool>& left,
                  std::span<const Task> tasks, Faults& faults) {
    std::vector<std::size_t> walk_of(sets.size(), 0);
    for (std::size_t i = 0; i < sets.size(); ++i) {
        if (!left[i] || walk_of[i] != 0) continue;
        std::vector<std::size_t> walk;
        std::size_t at = i;
        while (walk_of[at] == 0) {
            walk_of[at] = i + 1;
            walk.push_back(at);
            at = *std::find_if(sets[at].behind.begin(), sets[at].behind.end(),
                               [&](std::size_t j) { return left[j]; });
        }
        if (walk_of[at] != i + 1) continue;  // a circle that is told
        walk.erase(walk.begin(), std::find(walk.begin(), walk.end(), at));
        std::rotate(walk.begin(), std::min_element(walk.begin(), walk.end()), walk.end());
        std::string circle;
        for (const std::size_t j : walk) circle += fmt::format("{} -> ", sets[j].name.second);
        const Block& block = *tasks[walk[0]].block;
        const int id = sets[walk[0]].name.second;
        faults.begin_block();
        faults.fault(block.place, fmt::format("*{} {}, expected no set that contains itself: {}{}",
                                              block.keyword, id, circle, id));
    }
}

}  // namespace

void order_sets(std::vector<Task>& tasks, const Parameters& parameters, Faults& faults,
                DraftNames& names) {
    const auto is_sum = [](const Task& task) {
        return task.match.keyword->phase == Phase::SUM_OF_SETS;
    };
    const auto begin = std::find_if(tasks.begin(), tasks.end(), is_sum);
    const auto end = std::find_if_not(begin, tasks.end(), is_sum);
    const std::vector<Task> written(begin, end);
    std::vector<SetOfSets> sets;
    sets.reserve(written.size());
    for (const Task& task : written) sets.push_back(names_in(task, parameters, names));
    find_uses(sets);
    std::vector<bool> left(sets.size(), true);
    auto to = begin;
    for (const std::size_t i : order_of(sets)) {
        *to++ = written[i];
        left[i] = false;
    }
    tasks.erase(to, end);
    for (std::size_t i = 0; i < sets.size(); ++i)
        if (left[i]) sets[i].name.first->spoil(sets[i].name.second);
    tell_circles(sets, left, written, faults);
}

}  // namespace corpuscle::io::keywords
