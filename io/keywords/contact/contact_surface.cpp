// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "io/keywords/contact/contact_surface.hpp"

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

/// The parts of the listed shells; of those that are not whole, the shells.
ContactSide listed_side(const Draft& draft, const std::vector<std::uint8_t>& is_listed) {
    std::vector<std::uint8_t> has(draft.model.parts.size(), 0), lacks(has);
    for (std::size_t s = 0; s < is_listed.size(); ++s) {
        const Index part = draft.model.shells[s].part;
        if (part >= 0) (is_listed[s] != 0 ? has : lacks)[static_cast<std::size_t>(part)] = 1;
    }
    ContactSide side;
    for (std::size_t p = 0; p < has.size(); ++p)
        if (has[p] != 0) side.parts.push_back(static_cast<Index>(p));
    for (std::size_t s = 0; s < is_listed.size(); ++s) {
        const Index part = draft.model.shells[s].part;
        if (part >= 0 && is_listed[s] != 0 && lacks[static_cast<std::size_t>(part)] != 0)
            side.some_shells.push_back(static_cast<Index>(s));
    }
    return side;
}

ContactSide of_shells(const Draft& draft, const Rows& shells) {
    std::vector<std::uint8_t> is_listed(draft.model.shells.size(), 0);
    for (const Index shell : shells) is_listed[static_cast<std::size_t>(shell)] = 1;
    return listed_side(draft, is_listed);
}

/// Segments are those shells that have their nodes, in any order.
ContactSide of_segments(Card& c, const Draft& draft, const SideFields& side,
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
        c.fault(side.surface, fmt::format("segments that are shells: {} of this set are none",
                                          wanted.size() - found.size()));
        return {};
    }
    return listed_side(draft, is_listed);
}

/// The shells all of whose nodes are listed; nodes that would be left out bring the shells that
/// have them.
ContactSide of_nodes(Card& c, const Draft& draft, const SideFields& side, const Rows& nodes) {
    const auto& shells = draft.model.shells;
    std::vector<std::uint8_t> is_listed(draft.model.x.size(), 0), is_covered(is_listed),
        is_on(shells.size(), 0);
    for (const Index node : nodes) is_listed[static_cast<std::size_t>(node)] = 1;
    const auto count = [&](const Shell& shell, const std::vector<std::uint8_t>& of) {
        return std::count_if(shell.nodes.begin(), shell.nodes.end(), [&](Index node) {
            return node >= 0 && of[static_cast<std::size_t>(node)] != 0;
        });
    };
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (count(shells[s], is_listed) != 4) continue;
        is_on[s] = 1;
        for (const Index node : shells[s].nodes) is_covered[static_cast<std::size_t>(node)] = 1;
    }
    std::size_t more = 0;
    for (std::size_t s = 0; s < shells.size(); ++s) {
        if (is_on[s] != 0 || count(shells[s], is_listed) == 0) continue;
        bool is_needed = false;
        for (const Index node : shells[s].nodes) {
            const auto n = static_cast<std::size_t>(node);
            is_needed |= node >= 0 && is_listed[n] != 0 && is_covered[n] == 0;
        }
        if (!is_needed) continue;
        is_on[s] = 1;
        ++more;
        for (const Index node : shells[s].nodes)
            if (node >= 0) is_covered[static_cast<std::size_t>(node)] = 1;
    }
    for (const Index node : nodes)
        if (is_covered[static_cast<std::size_t>(node)] == 0) {
            c.fault(side.surface, fmt::format("nodes of shells: node {} is of none",
                                              draft.model.node_id[static_cast<std::size_t>(node)]));
            return {};
        }
    if (more > 0)
        c.warn(
            side.surface,
            fmt::format("nodes are taken with shells that they are of: {} shells have nodes that "
                        "are not of this set, which touch too",
                        more));
    return listed_side(draft, is_on);
}

}  // namespace

ContactSide contact_side(Card& c, const Draft& draft, const SideFields& side, bool may_be_nodes) {
    const bool is_named = c.given(side.surface) && c.integer(side.surface) != 0;
    if (!is_named) {
        c.integer(side.type, within(0, 6));
        return {all_parts(draft), {}};
    }
    const int type = may_be_nodes ? c.choice(side.type, {0, 1, 2, 3, 4, 5, 6})
                                  : c.choice(side.type, {0, 1, 2, 3, 5, 6});
    if (!c.good()) return {};
    if (type == 5) return {all_parts(draft), {}};
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
            return of_shells(draft, draft.shell_set[at]);
        case 2:
            return {draft.part_set[at], {}};
        case 3:
            return {{row}, {}};
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
    return {rest, {}};
}

void keep_in_box(Card& c, const Draft& draft, std::string_view field, ContactSide& side) {
    const Index row = c.row_or_none(field, draft.boxes);
    if (row < 0) return;
    const SetBox& box = draft.box[static_cast<std::size_t>(row)];
    std::vector<std::uint8_t> is_of(draft.model.parts.size(), 0), is_parted(is_of),
        is_on(draft.model.shells.size(), 0);
    for (const Index part : side.parts) is_of[static_cast<std::size_t>(part)] = 1;
    for (const Index shell : side.some_shells) {
        is_on[static_cast<std::size_t>(shell)] = 1;
        is_parted[static_cast<std::size_t>(
            draft.model.shells[static_cast<std::size_t>(shell)].part)] = 1;
    }
    for (std::size_t s = 0; s < is_on.size(); ++s) {
        const Shell& shell = draft.model.shells[s];
        if (shell.part < 0) continue;
        const auto part = static_cast<std::size_t>(shell.part);
        const bool is_meant = is_parted[part] != 0 ? is_on[s] != 0 : is_of[part] != 0;
        is_on[s] = is_meant && std::all_of(shell.nodes.begin(), shell.nodes.end(), [&](Index n) {
                       return n >= 0 && box.contains(draft.model.x[static_cast<std::size_t>(n)]);
                   });
    }
    side = listed_side(draft, is_on);
    if (side.parts.empty()) c.fault(field, "a box with shells of this side in it");
}

}  // namespace corpuscle::io::keywords
