// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/contact_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <string>

namespace corpuscle::io::keywords {

namespace {

using Rows = std::vector<Index>;

Rows all_parts(const Draft& draft) {
    Rows all(draft.model.parts.size());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

/// The parts of which every shell is listed; a fault when a shell of another part is too.
Rows whole_parts(Card& c, const Draft& draft, const SideFields& side,
                 const std::vector<std::uint8_t>& is_listed) {
    std::vector<std::uint8_t> has(draft.model.parts.size(), 0), lacks(has);
    for (std::size_t s = 0; s < is_listed.size(); ++s) {
        const Index part = draft.model.shells[s].part;
        if (part >= 0) (is_listed[s] != 0 ? has : lacks)[static_cast<std::size_t>(part)] = 1;
    }
    Rows parts;
    for (std::size_t p = 0; p < has.size(); ++p) {
        if (has[p] == 0) continue;
        if (lacks[p] != 0) {
            c.fault(side.surface, fmt::format("a set of whole parts: it holds some shells of part "
                                              "{}, not all",
                                              draft.model.parts[p].id));
            return {};
        }
        parts.push_back(static_cast<Index>(p));
    }
    return parts;
}

Rows of_shells(Card& c, const Draft& draft, const SideFields& side, const Rows& shells) {
    std::vector<std::uint8_t> is_listed(draft.model.shells.size(), 0);
    for (const Index shell : shells) is_listed[static_cast<std::size_t>(shell)] = 1;
    return whole_parts(c, draft, side, is_listed);
}

/// Segments are those shells that have their nodes, in any order.
Rows of_segments(Card& c, const Draft& draft, const SideFields& side,
                 const std::vector<std::array<Index, 4>>& segments) {
    const auto key = [](std::array<Index, 4> nodes) {
        std::sort(nodes.begin(), nodes.end());
        // a triangle repeats one of its nodes, not always the same one
        for (std::size_t i = 1; i < nodes.size(); ++i)
            if (nodes[i] == nodes[i - 1]) {
                std::copy(nodes.begin() + static_cast<long>(i) + 1, nodes.end(),
                          nodes.begin() + static_cast<long>(i));
                nodes.back() = -1;
                break;
            }
        return nodes;
    };
    std::set<std::array<Index, 4>> wanted;
    for (const auto& segment : segments) wanted.insert(key(segment));
    std::vector<std::uint8_t> is_listed(draft.model.shells.size(), 0);
    std::set<std::array<Index, 4>> found;
    for (std::size_t s = 0; s < is_listed.size(); ++s)
        if (const auto nodes = key(draft.model.shells[s].nodes); wanted.contains(nodes)) {
            is_listed[s] = 1;
            found.insert(nodes);
        }
    if (found.size() < wanted.size()) {
        c.fault(side.surface, fmt::format("a set of whole parts: {} of its segments are no shells",
                                          wanted.size() - found.size()));
        return {};
    }
    return whole_parts(c, draft, side, is_listed);
}

/// The parts all of whose nodes are listed, if these are all that are listed.
Rows of_nodes(Card& c, const Draft& draft, const SideFields& side, const Rows& nodes) {
    std::vector<std::uint8_t> is_listed(draft.model.x.size(), 0), is_covered(is_listed);
    for (const Index node : nodes) is_listed[static_cast<std::size_t>(node)] = 1;
    std::vector<std::uint8_t> is_used(draft.model.parts.size(), 0), lacks(is_used);
    const auto for_each_corner = [&](auto&& act) {
        for (const Shell& shell : draft.model.shells)
            for (const Index node : shell.nodes)
                if (node >= 0 && shell.part >= 0)
                    act(static_cast<std::size_t>(shell.part), static_cast<std::size_t>(node));
    };
    for_each_corner([&](std::size_t part, std::size_t node) {
        is_used[part] = 1;
        if (is_listed[node] == 0) lacks[part] = 1;
    });
    for_each_corner([&](std::size_t part, std::size_t node) {
        if (lacks[part] == 0) is_covered[node] = 1;
    });
    for (const Index node : nodes)
        if (is_covered[static_cast<std::size_t>(node)] == 0) {
            c.fault(side.surface,
                    fmt::format("a set of all nodes of whole parts: node {} is of no such part",
                                draft.model.node_id[static_cast<std::size_t>(node)]));
            return {};
        }
    Rows parts;
    for (std::size_t p = 0; p < lacks.size(); ++p)
        if (is_used[p] != 0 && lacks[p] == 0) parts.push_back(static_cast<Index>(p));
    return parts;
}

}  // namespace

std::vector<Index> contact_side(Card& c, const Draft& draft, const SideFields& side,
                                bool may_be_nodes) {
    const bool is_named = c.given(side.surface) && c.integer(side.surface) != 0;
    if (!is_named) {
        c.integer(side.type, within(0, 6));
        return all_parts(draft);
    }
    const int type = may_be_nodes ? c.choice(side.type, {0, 1, 2, 3, 4, 5, 6})
                                  : c.choice(side.type, {0, 1, 2, 3, 5, 6});
    if (!c.good()) return {};
    if (type == 5) return all_parts(draft);
    const Registry* named[] = {&draft.segment_sets, &draft.shell_sets, &draft.part_sets,
                               &draft.parts,        &draft.node_sets,  nullptr,
                               &draft.part_sets};
    const Index row = c.row(side.surface, *named[type]);
    if (row < 0) return {};
    const auto at = static_cast<std::size_t>(row);
    switch (type) {
        case 0:
            return of_segments(c, draft, side, draft.segment_set[at]);
        case 1:
            return of_shells(c, draft, side, draft.shell_set[at]);
        case 2:
            return draft.part_set[at];
        case 3:
            return {row};
        case 4:
            return of_nodes(c, draft, side, draft.node_set[at]);
        default:
            break;
    }
    Rows rest = all_parts(draft);
    const Rows& left_out = draft.part_set[at];
    std::erase_if(rest, [&](Index part) {
        return std::find(left_out.begin(), left_out.end(), part) != left_out.end();
    });
    return rest;
}

}  // namespace corpuscle::io::keywords
