// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "contact/candidates/shared_nodes.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace corpuscle::contact {
namespace {

/// visit(node, block, lane) for all nodes of all lanes.
template <int CORNERS, class Visit>
void for_each_node(const Blocks<CORNERS>& blocks, Index begin, Index end, Visit&& visit) {
    for (Index b = begin; b < end; ++b)
        for (int lane = 0; lane < EIGHT; ++lane) {
            if (blocks[b].triangle[lane] < 0) continue;
            for (const Index node : blocks[b].node[lane]) visit(node, b, lane);
        }
}

}  // namespace

template <int A, int B>
SharedNodes::SharedNodes(const Blocks<A>& mine, const Blocks<B>& others) : start_{0} {
    struct Corner {
        Index node, block;
        int lane;
    };
    std::vector<Corner> places;
    for_each_node(others, 0, others.start().back(), [&](Index node, Index b, int lane) {
        places.push_back({node, b, lane});
    });
    const auto by_node = [](const Corner& a, const Corner& b) { return a.node < b.node; };
    std::stable_sort(places.begin(), places.end(), by_node);
    std::map<Index, std::uint64_t> found;  // by the other block
    for (Index block = 0; block < mine.start().back(); ++block) {
        found.clear();
        for_each_node(mine, block, block + 1, [&](Index node, Index, int lane) {
            const auto [first, last] =
                std::equal_range(places.begin(), places.end(), Corner{node, 0, 0}, by_node);
            for (auto place = first; place != last; ++place)
                found[place->block] |= std::uint64_t{1} << (EIGHT * lane + place->lane);
        });
        for (const auto& [other, lanes] : found) entry_.push_back({other, lanes});
        start_.push_back(static_cast<Index>(entry_.size()));
    }
}

template SharedNodes::SharedNodes(const Blocks<2>&, const Blocks<2>&);
template SharedNodes::SharedNodes(const Blocks<1>&, const Blocks<3>&);
template SharedNodes::SharedNodes(const Blocks<3>&, const Blocks<1>&);

}  // namespace corpuscle::contact
