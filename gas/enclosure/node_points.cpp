// corpuscle: airbag deployment by the corpuscular method
// SPDX-License-Identifier: MIT
#include "gas/enclosure/node_points.hpp"

#include <algorithm>

namespace corpuscle::gas {

NodePoints::NodePoints(const WettedSurface& surface, std::span<const Index> more,
                       std::size_t count) {
    place.assign(count, -1);
    for (std::size_t p = 0; p < surface.points(); ++p) nodes.push_back(surface.node(p));
    nodes.insert(nodes.end(), more.begin(), more.end());
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (std::size_t i = 0; i < nodes.size(); ++i) place[nodes[i]] = static_cast<Index>(i);
    start.assign(nodes.size() + 1, 0);
    for (std::size_t p = 0; p < surface.points(); ++p) ++start[place[surface.node(p)] + 1];
    for (std::size_t i = 0; i < nodes.size(); ++i) start[i + 1] += start[i];
    points.resize(surface.points());
    std::vector<Index> fill(start.begin(), start.end() - 1);
    for (std::size_t p = 0; p < surface.points(); ++p)
        points[fill[place[surface.node(p)]]++] = static_cast<Index>(p);
}

}  // namespace corpuscle::gas
